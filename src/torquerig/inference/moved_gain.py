"""Residuals of a run when one gain of the load's spectrum moves: only what that gain acts on is evaluated."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.likelihood import BAND, COMMON, LEVEL, LINE, Discrepancy, Residuals, residuals_of
from torquerig.inference.load_spectrum import GainShapes, with_gains
from torquerig.inference.prediction.expected_run import ExpectedRun

Floats = NDArray[np.float64]


def values_with_moved_gain(
    seen: RunFeatures, shape: GainShapes, model: ExpectedRun, before: Residuals, *, gains: Floats, off: Discrepancy,
    moved: int,
) -> Floats:  # fmt: skip
    """Return the residuals of a run, shape (features,), at ``gains``; ``before`` are those with ``moved`` elsewhere.

    Parameters
    ----------
    model : ExpectedRun
        Gains not applied.
    gains : ndarray, shape (gains,)
        In standard deviations; they differ from those of ``before`` in the gain with the index ``moved`` alone.
    """
    if not shape.acts(moved):
        return before.value
    louder = with_gains(model, shape, gains)
    values = [residuals_of(seen, louder, off, kind).value for kind in (LINE, BAND)]
    levels, common = (before.value[before.kind == kind] for kind in (LEVEL, COMMON))
    levels = residuals_of(seen, louder, off, LEVEL).value if shape.levels[moved] else levels
    return np.concatenate([*values, levels, common])
