"""Which way a shaft turned whose tacho counts upwards either way: that of its set-point."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_LATE = 0.03  # of the recording: by so much a drive may be later or earlier than its set-point turns back
_WINDOW = 1 / 600  # of the recording, over which the speed is a mean


def directed(angle: Floats, set_point: Floats) -> Floats:
    """Return an angle with the direction of a set-point.

    Parameters
    ----------
    angle : ndarray, shape (samples,)
        Of the motor [rad], counted upwards or downwards whichever way it turned.
    set_point : ndarray, shape (samples,)
        Of the motor's speed [rad/s].
    """
    steps = np.abs(np.diff(angle))
    wide = max(int(_WINDOW * angle.size), 1)
    speed = np.convolve(steps, np.ones(wide) / wide, mode="same")
    way = np.sign(set_point[:-1])
    way[way == 0] = np.nan
    turning = np.flatnonzero(way[~np.isnan(way)][1:] != way[~np.isnan(way)][:-1])
    known = np.flatnonzero(~np.isnan(way))
    edges, signs = [0], [way[known[0]] if known.size else 1.0]
    for one in turning.tolist():
        at, reach = int(known[one]), int(_LATE * steps.size)
        low, high = max(at - reach, edges[-1]), min(at + reach + 1, steps.size)
        edges.append(low + int(np.argmin(speed[low:high])))
        signs.append(float(way[known[one + 1]]))
    sign = np.repeat(signs, np.diff([*edges, steps.size]))
    return np.asarray(angle[0] + np.concatenate([[0.0], np.cumsum(steps * sign)]))
