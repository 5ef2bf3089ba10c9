"""Residuals of held-out data before and after, and how sure the improvement is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.answer.numbers import TWO_SIDED, digits
from torquerig.inference.answer.sizes import without
from torquerig.inference.discrepancy import usual
from torquerig.inference.engine import Outcome
from torquerig.inference.fit import Data, Fit, all_residuals
from torquerig.inference.held_out import held_residuals, residuals_of_means
from torquerig.inference.likelihood import Residuals
from torquerig.inference.prediction.expected_run import expected_run

Floats = NDArray[np.float64]

METRIC = (
    "Mean squared standardised residual of held-out data; about 1 for a true model. The data are the logarithms of the "
    "power of lines and of the density of bands, and mean torques, each divided by its standard deviation: sampling "
    "error and what a right model may be wrong by, as estimated with the completed model."
)
IMPROVABLE = 1.2  # a model with a smaller residual before leaves nothing to improve (the contract's limit)


def fit_figures(outcome: Outcome) -> dict[str, Any]:
    """Return metric, residuals before and after, and the improvement with its 95 % interval, None where pointless.

    All have the load and the discrepancy of the completed model: those of an incomplete one are larger, and its
    residuals would look small.
    """
    off = usual(outcome.model.fit.off)
    stated, fit = replace(outcome.stated, off=off), replace(outcome.model.fit, off=off)
    after = _squares(held_residuals(fit, outcome.held))
    if outcome.setup:  # its features are others
        before = _squares(held_residuals(stated, outcome.stated_held))
    else:
        rig = without(fit.fitted_rig, outcome.model.additions)
        before = _squares(residuals_of_means(stated, fit, outcome.held, rig))
    old, new = float(before.mean()), float(after.mean())
    return {
        "metric": METRIC,
        "before": {"heldout_misfit": digits(old), "nominal": digits(_unfitted(stated, outcome.stated_held))},
        "after": {"heldout_misfit": digits(new)},
        "improvement": None if old < IMPROVABLE else {"value": digits(1 - new / old), "ci95": _interval(before, after)},
    }


def _squares(runs: Sequence[Residuals]) -> Floats:
    return np.concatenate([each.standardised**2 for each in runs])


def _unfitted(fit: Fit, held: Data) -> float:
    """Return the residual of the scenario as it is stated."""
    expected = [expected_run(fit.nominal, seen) for seen in held.seen]
    return float(_squares(all_residuals(held, expected, np.zeros_like(fit.gains), fit.off)).mean())


def _interval(before: Floats, after: Floats) -> list[float]:
    """Return the interval of ``1 - mean(after) / mean(before)``, by the scatter over the features.

    Where a fault of the set-up was corrected, both have features of their own; they are then independent.
    """
    share = 1 - float(after.mean() / before.mean())
    if before.size == after.size:
        scatter = float(np.std(after - (1 - share) * before)) / np.sqrt(before.size)
    else:
        scatter = float(np.hypot(after.std() / np.sqrt(after.size), (1 - share) * before.std() / np.sqrt(before.size)))
    half = TWO_SIDED * scatter / float(before.mean())
    return [digits(share - half), digits(share + half)]
