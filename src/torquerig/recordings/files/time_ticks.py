"""Times in whole ticks with several samples each: seconds of a clock at 50 Hz."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.time_band import narrowest_band

# whole ticks from which the number of samples in a tick is known [1]
_LEAST = 3
# largest difference of two ticks that are equal: binary numbers of decimal times [1]
_EQUAL = 1e-6
# even times that are rounded lie in a band of one tick, which a lost sample widens [1]
_ONE_TICK = 1.01
# largest deviation of a step from whole ticks, of steps known to 0.001 of the usual one [1]
_WHOLE = 0.05


def rate_of_ticks(times: NDArray[np.float64]) -> tuple[float, float, float] | None:
    """Return rate [Hz], its relative uncertainty and the tick [s], where each whole tick has as many samples.

    None where they have not.

    The first and the last tick may be shorter. Ticks of an even rate differ by at most one sample; where the file
    begins and ends within a sample leaves one sample of all whole ticks open.

    Parameters
    ----------
    times : ndarray, shape (samples,)
        [s], never falling.
    """
    edges = np.flatnonzero(np.diff(times)) + 1
    whole = np.diff(edges)
    if whole.size < _LEAST or whole.min() < 2 or np.ptp(whole) > 1:
        return None
    ticks = np.diff(times[np.append(edges, edges[-1]) - np.append(np.ones(edges.size, dtype=np.int64), 0)])
    tick = float(np.median(ticks))
    if np.any(np.abs(ticks - tick) > _EQUAL * tick) or max(edges[0], times.size - edges[-1]) > whole.max():
        return None
    if narrowest_band(times)[0] > _ONE_TICK * tick:
        return None
    samples = int(whole.sum())
    return samples / (whole.size * tick), 1 / samples, tick


def are_whole(steps: NDArray[np.float64]) -> bool:
    """Return whether steps, in ticks, are whole ones, as rounded times have: no long gap among even steps."""
    return bool(np.all(np.abs(steps - np.round(steps)) <= _WHOLE) and not np.any((steps > 0) & (np.round(steps) == 0)))
