"""Rise time of a signal from 10 % to 90 % of its peak."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def rise_time(values: NDArray[np.float64], rate: float, *, top: float | None = None) -> float:
    """Return the time from the last sample below 10 % to the first above 90 % before or at the peak [s].

    Crossings between two samples are interpolated linearly; 0 where the signal does not rise.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Relative to the level before the rise.
    rate : float
        [Hz].
    top : float, optional
        The level of 100 %; the peak by default.
    """
    height = float(values.max(initial=0.0)) if top is None else top
    if not height > 0:
        return 0.0
    above = np.flatnonzero(values >= 0.9 * height)
    if above.size == 0:
        return 0.0
    high = int(above[0])
    below = np.flatnonzero(values[:high] <= 0.1 * height)
    low = int(below[-1]) if below.size else 0
    return (_crossing(values, high - 1, 0.9 * height) - _crossing(values, low, 0.1 * height)) / rate


def _crossing(values: NDArray[np.float64], before: int, level: float) -> float:
    """Return the position where the signal crosses ``level`` after the sample ``before`` [samples]."""
    if before < 0 or before + 1 >= values.size:
        return float(max(before, 0))
    first, second = float(values[before]), float(values[before + 1])
    return before + (min(max((level - first) / (second - first), 0.0), 1.0) if second != first else 0.0)
