"""Whether a fitted model explains the features: the largest residual and their sum, by kind, as p-values.

Under the model the standardised residuals follow the likelihood's distribution, Student's. The largest of n has the
p-value ``1 - F(|z|)^n``; the sum of the deviances ``(nu + 1) ln(1 + z^2 / nu)`` is compared with a normal
distribution of their mean and variance, which holds for some ten features and more. The smallest p-value counts for
as many tests as there are (Bonferroni).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.likelihood import BAND, DEGREES_OF_FREEDOM, LEVEL, LINE, Residuals

Floats = NDArray[np.float64]

LEVEL_OF_TEST = 0.01  # p-value below which a model does not explain the data
_KINDS = {LINE: "lines", BAND: "bands", LEVEL: "levels"}


@dataclass(frozen=True)
class Excess:
    """One statistic of one kind of features.

    Parameters
    ----------
    statistic : str
        ``largest`` or ``sum``, with the kind.
    p_value : float
        For all tests together [1].
    run, kind, row : int
        Of the largest residual: which run, which kind, which of the run's residuals.
    """

    statistic: str
    p_value: float
    run: int
    kind: int
    row: int


def excesses(runs: Sequence[Residuals]) -> tuple[Excess, ...]:
    """Return the statistics of a model's residuals, the least likely first."""
    from scipy.stats import norm, t

    nu, found = DEGREES_OF_FREEDOM, list[Excess]()
    mean, variance = _deviance_moments()
    for kind, name in _KINDS.items():
        rows = [np.flatnonzero(each.kind == kind) for each in runs]
        values = [each.standardised[own] for each, own in zip(runs, rows, strict=True)]
        count = sum(each.size for each in values)
        if not count:
            continue
        run = int(np.argmax([np.abs(each).max(initial=0.0) for each in values]))
        row = int(np.argmax(np.abs(values[run])))
        worst = float(np.abs(values[run][row]))
        largest = -np.expm1(count * np.log1p(-min(2 * float(t.sf(worst, nu)), 1 - 1e-16)))
        deviance = sum(float(np.sum((nu + 1) * np.log1p(each**2 / nu))) for each in values)
        total = float(norm.sf((deviance - count * mean) / np.sqrt(count * variance)))
        at = int(rows[run][row])
        found += [Excess(f"largest of {name}", largest, run, kind, at), Excess(f"sum of {name}", total, run, kind, at)]
    tests = max(len(found), 1)
    return tuple(sorted(
        (Excess(each.statistic, min(tests * each.p_value, 1.0), each.run, each.kind, each.row) for each in found),
        key=lambda each: each.p_value,
    ))  # fmt: skip


def _deviance_moments() -> tuple[float, float]:
    """Return mean and variance of the deviance of one residual."""
    from scipy.special import digamma, polygamma

    nu = DEGREES_OF_FREEDOM
    mean = (nu + 1) * float(digamma(0.5 * (nu + 1)) - digamma(0.5 * nu))
    return mean, (nu + 1) ** 2 * float(polygamma(1, 0.5 * nu) - polygamma(1, 0.5 * (nu + 1)))
