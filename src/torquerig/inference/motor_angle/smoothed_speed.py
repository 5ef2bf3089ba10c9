"""The speed of the motor by its angle, and whether it changes its direction."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_WINDOW = 0.05  # [s] over which an encoder's steps average out and a ramp does not
_BACKWARD = 0.05  # [1] of the largest speed: less is what a shaft sways by near standstill


def speed_of(angle: Floats, rate: float, *, window: float = _WINDOW) -> Floats:
    """Return the speed [rad/s] at each sample of an angle [rad], as a mean over ``window`` [s]."""
    reach = max(1, int(0.5 * window * rate))
    at = np.arange(angle.size)
    low, high = np.maximum(at - reach, 0), np.minimum(at + reach, angle.size - 1)
    return np.asarray((angle[high] - angle[low]) / (high - low) * rate)


def turns_back(speed: Floats) -> bool:
    """Return whether a motor of these speeds [rad/s] runs both ways."""
    return float(speed.min()) < -_BACKWARD * float(np.abs(speed).max()) < 0 < float(speed.max())
