"""How probable a residual is where many places were looked at, and what of a misfit is no chance."""

from __future__ import annotations

from math import erfc, sqrt

import numpy as np
from numpy.typing import NDArray

_BY_CHANCE = 4.0  # squares of residuals below this are no misfit


def by_chance(residual: float, places: int) -> float:
    """Return the two-sided probability of a normal residual so large somewhere among ``places`` (Bonferroni) [1]."""
    return min(1.0, places * erfc(residual / sqrt(2)))


def beyond_chance(squares: NDArray[np.float64]) -> float:
    """Return the sum of squared residuals, of each what chance makes too taken off."""
    return float(np.maximum(squares - _BY_CHANCE, 0.0).sum())
