"""Rounding to a grid on which sums and differences are exact."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

STEP = 2.0**-40
"""9.1e-13: far below any converter's step, and sums below 2^12 are exact in float64 whatever their order."""


def on_grid(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return ``values`` rounded to whole multiples of ``STEP``; -0 becomes 0."""
    return np.asarray(np.round(values / STEP) * STEP + 0.0, dtype=np.float64)
