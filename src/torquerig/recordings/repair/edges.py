"""Edges of a signal: what it does within some samples beyond its slope, and whether it stays where that put it."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_STAYS = (0.001, 0.004)  # [s] for which the mean must stand higher or lower by the height
_OF_THE_HEIGHT, _SPREADS = 0.2, 4.0  # within which it must


def differences_over(volts: Floats, lag: int) -> Floats:
    """Return by how much the sample ``lag`` later is larger, shape (samples - lag,)."""
    return volts[lag:] - volts[:-lag]


def edges_over(volts: Floats, lag: int) -> Floats:
    """Return those differences less the mean of the two beside them: what is smooth over three lags leaves nothing."""
    differences = differences_over(volts, lag)
    answer = np.zeros(differences.size)
    if differences.size > 2 * lag:
        answer[lag:-lag] = differences[lag:-lag] - 0.5 * (differences[: -2 * lag] + differences[2 * lag :])
    return answer


def stays_so(volts: Floats, rate: float, at: NDArray[np.int64], heights: Floats, *, lag: int) -> NDArray[np.bool_]:
    """Return at which samples the means of some milliseconds after ``lag`` samples stand higher by the heights."""
    stays = np.ones(at.size, dtype=bool)
    for length in _STAYS:
        reach = max(round(length * rate), 2 * lag)
        change = partial(_change, np.concatenate([[0.0], np.cumsum(volts)]), reach=reach, lag=lag)
        among = spread_about_zero(change(np.arange(0, volts.size - lag, reach)))
        within = np.maximum(_OF_THE_HEIGHT * np.abs(heights), _SPREADS * among)
        stays &= np.abs(change(at) - heights) < within
    return stays


def largest_of_each(sizes: Floats, clear: NDArray[np.int64], *, apart: int) -> NDArray[np.int64]:
    """Return the largest of each cluster of clear differences."""
    if not clear.size:
        return clear
    clusters = np.split(clear, np.flatnonzero(np.diff(clear) > apart) + 1)
    return np.array([cluster[np.argmax(sizes[cluster])] for cluster in clusters])


def _change(total: Floats, at: NDArray[np.int64], *, reach: int, lag: int) -> Floats:
    """Return the mean over ``reach`` samples after a jump of ``lag`` samples less that before it."""
    before, after = np.maximum(at + 1 - reach, 0), np.minimum(at + lag + reach, total.size - 1)
    higher = (total[after] - total[at + lag]) / (after - at - lag)
    return np.asarray(higher - (total[at + 1] - total[before]) / (at + 1 - before))
