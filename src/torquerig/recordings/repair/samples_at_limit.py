"""Moments at the converter's or an amplifier's limit: a single hit of a heavy load may reach it.

A flat top of a few milliseconds rings through all bands of a quiet spectrum, where a filter had left nothing.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.moments import moments_of

_AT_LIMIT = 0.9995  # of it
_SLOPE = 5e-4  # [s] each side, over which the slope into and out of the moment is taken
_MOST = 0.02  # share of the samples beyond which nothing can be rebuilt


def at_limit(recording: Recording, *, limit: float) -> NDArray[np.bool_]:
    """Return which samples of the torque channel stand at a limit, either way [V]."""
    return np.abs(recording.torque_values()) >= _AT_LIMIT * limit


def too_long(stuck: NDArray[np.bool_]) -> bool:
    """Whether so many samples stand at a limit that nothing can be rebuilt."""
    return bool(stuck.mean() > _MOST)


def rebuilt(recording: Recording, *, limit: float) -> Recording:
    """Return the recording with cubics over the moments at a limit, by value and slope at their ends.

    It is the same object where there are none, or so many that nothing can be rebuilt.

    Parameters
    ----------
    recording : Recording
    limit : float
        Either way [V].
    """
    from scipy.interpolate import CubicHermiteSpline

    volts = recording.torque_values()
    stuck = at_limit(recording, limit=limit)
    if not stuck.any() or too_long(stuck):
        return recording
    reach = max(2, round(_SLOPE * recording.sample_rate))
    stuck |= np.convolve(stuck, np.ones(2 * reach + 1), "same") > reach  # what returns for a moment is one with it
    answer = volts.copy()
    for start, stop in moments_of(stuck):
        first, last = start - 1, stop
        if first < reach or last + reach >= volts.size:
            continue
        rising, falling = (volts[first] - volts[first - reach]) / reach, (volts[last + reach] - volts[last]) / reach
        cubic = CubicHermiteSpline([first, last], [volts[first], volts[last]], [rising, falling])
        answer[start:stop] = cubic(np.arange(start, stop))
    return recording.with_values(recording.torque_name(), answer)
