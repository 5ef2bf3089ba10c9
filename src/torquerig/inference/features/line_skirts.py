"""Whether a peak of a spectrum is a line, or one of many peaks of something wider than a bin."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_RAISED = 3.0  # [1] times the noise: the median of five bins of noise exceeds it once in a thousand
_FILTER = 5  # bins of that median; a sharp line under a Hann window raises three bins
_SURROUNDINGS = 12  # bins either way, at least, whose median is the level around a peak
_FARTHEST = 500  # bins either way to which such a range is followed
_TOP = 3  # [bins] so near to the highest bin a peak is that one
_MEDIAN_OF_EXPONENTIAL = float(np.log(2.0))


def exceeds_surroundings(ratios: Floats, at: int, *, level: float) -> bool:
    """Return whether the peak at bin ``at`` is a line.

    Parameters
    ----------
    ratios : ndarray, shape (bins,)
        Power over noise [1]; NaN where a known line was removed.
    at : int
    level : float
        p-value below which a peak is no random error of the level around it: within the range of bins that exceed the
        noise without a gap, exponential variates about their median. The highest peak of a range without a known line
        needs none.
    """
    low, high = raised_range(ratios, at)
    inside = ratios[low:high]
    is_alone = bool(np.isfinite(inside).all())
    if is_alone and abs(low + int(np.argmax(inside)) - at) <= _TOP:
        return True
    around = ratios[max(min(low, at - _SURROUNDINGS), 0) : max(high, at + _SURROUNDINGS + 1)]
    around = around[np.isfinite(around)]
    typical = max(float(np.median(around)) / _MEDIAN_OF_EXPONENTIAL, 1.0)
    return bool(np.nanmax(ratios[max(at - 1, 0) : at + 2]) > typical * np.log(around.size / level))


def raised_range(ratios: Floats, at: int) -> tuple[int, int]:
    """Return the first bin and one past the last of the range around ``at`` that exceeds the noise without a gap."""
    from scipy.ndimage import median_filter

    first = max(at - _FARTHEST, 0)
    near = ratios[first : at + _FARTHEST]
    filled = np.where(np.isfinite(near), near, np.inf)
    quiet = first + np.flatnonzero(median_filter(filled, size=_FILTER, mode="nearest") <= _RAISED)
    after = int(np.searchsorted(quiet, at))
    low = int(quiet[after - 1]) + 1 if after > 0 else first
    high = int(quiet[after]) if after < quiet.size else first + near.size
    return min(low, at), max(high, at + 1)
