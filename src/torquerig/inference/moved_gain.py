"""Residuals of a run when one gain of the load's spectrum moves: only what that gain acts on is evaluated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.likelihood import BAND, LEVEL, LINE, Discrepancy, Residuals, residuals_of
from torquerig.inference.load_spectrum import GainShapes, with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]


def residuals_with_moved_gain(
    seen: RunFeatures, shape: GainShapes, model: ExpectedRun, before: Residuals, *, gains: Floats, off: Discrepancy,
    moved: int,
) -> Residuals:  # fmt: skip
    """Return the residuals of a run at ``gains``; ``before`` are those with ``moved`` elsewhere.

    Parameters
    ----------
    model : ExpectedRun
        Gains not applied.
    gains : ndarray, shape (gains,)
        In standard deviations; they differ from those of ``before`` in the gain with the index ``moved`` alone.
    """
    if not shape.acts(moved):
        return before
    louder = with_gains(model, shape, gains)
    kinds = (LINE, BAND, LEVEL) if shape.levels[moved] else (LINE, BAND)
    value, sd = before.value.copy(), before.sd.copy()
    for kind in kinds:
        there = residuals_of(seen, louder, off, kind)
        value[before.kind == kind], sd[before.kind == kind] = there.value, there.sd
    return replace(before, value=value, sd=sd)
