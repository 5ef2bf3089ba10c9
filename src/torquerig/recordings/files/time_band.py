"""The narrowest band between two parallel lines that holds all times."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

# stretches of which only the extremes are used; the error is the band's width over this number
_STRETCHES = 2000
# halvings of the interval of slopes: beyond the precision of a float
_HALVINGS = 80


def narrowest_band(times: NDArray[np.float64]) -> tuple[float, float]:
    """Return the height [s] of the narrowest band that holds ``times`` over their numbers, and its slope [s].

    Times that are rounded to a grain lie in a band of one grain around the true, even times.

    Parameters
    ----------
    times : ndarray, shape (samples,)
        [s].
    """
    samples = times.size
    mean = float(times[-1] - times[0]) / (samples - 1)
    numbers = np.arange(samples)
    off = times - times[0] - mean * numbers
    edges = np.unique(np.linspace(0, samples, min(samples, _STRETCHES) + 1).astype(np.int64))[:-1]
    high, low = np.maximum.reduceat(off, edges), np.minimum.reduceat(off, edges)
    stretch = np.repeat(np.arange(edges.size), np.diff(np.append(edges, samples)))
    at_high = _first_place(off == high[stretch], stretch, edges.size, numbers)
    at_low = _first_place(off == low[stretch], stretch, edges.size, numbers)

    def height(slope: float) -> float:
        return float(np.max(high - slope * at_high) - np.min(low - slope * at_low))

    # the height is a convex function of the slope
    reach = 4 * float(np.ptp(off)) / samples
    left, right = -reach, reach
    for _ in range(_HALVINGS):
        one, two = left + (right - left) / 3, right - (right - left) / 3
        if height(one) <= height(two):
            right = two
        else:
            left = one
    slope = (left + right) / 2
    return height(slope), mean + slope


def _first_place(
    found: NDArray[np.bool_], stretch: NDArray[np.int64], count: int, numbers: NDArray[np.int64]
) -> NDArray[np.int64]:
    places = np.zeros(count, dtype=np.int64)
    places[stretch[found][::-1]] = numbers[found][::-1]
    return places
