"""Jumps from one sample to the next in a signal that is smooth on either side: no shaft passes such a torque on.

An amplifier of some kHz spreads what comes from the shaft over several samples, and what is as fast as it rings: the
samples beside are large as well. A gain or a zero that jumps, and samples that are lost, stand alone.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.moments import Moments
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_BESIDE = 25  # differences on either side
_CLEAR = 14.0  # robust spreads of those, and of the run's by a third of it
_ALONE = 2.5  # times the largest of those


def sample_jumps(volts: Floats, lost: Moments = (), *, resolution: float = 0.0) -> NDArray[np.int64]:
    """Return the first samples after a jump.

    Parameters
    ----------
    volts : ndarray, shape (samples,)
    lost : sequence of (int, int)
        Moments without signal, whose ends are none.
    resolution : float
        One code [V].
    """
    steps = np.diff(volts)
    usual = max(spread_about_zero(steps), resolution)
    told = np.abs(steps) > 0.5 * _CLEAR * usual
    for start, stop in lost:
        told[max(start - _BESIDE, 0) : stop + _BESIDE] = False
    return np.array([at + 1 for at in np.flatnonzero(told) if _alone(steps, int(at), usual)], dtype=np.int64)


def _alone(steps: Floats, at: int, usual: float) -> bool:
    sides = steps[max(at - _BESIDE, 0) : at], steps[at + 1 : at + 1 + _BESIDE]
    if min(side.size for side in sides) < _BESIDE:
        return False
    spread = max(usual / 3, *(spread_about_zero(side) for side in sides))
    largest = max(float(np.abs(side).max()) for side in sides)
    return bool(abs(steps[at]) > max(_CLEAR * spread, _ALONE * largest))
