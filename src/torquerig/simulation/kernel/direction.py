"""The sign of a speed, smoothed."""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import any_of, where
from torquerig.simulation.kernel.elementary import hyperbolic_tangent
from torquerig.simulation.kernel.fast import FAST


@njit(fastmath=FAST, inline="always")
def direction(speed, inverse_smoothing):
    """Return the sign of a speed, smoothed as tanh."""
    scaled = speed * inverse_smoothing
    sign = where(scaled > 0.0, 1.0, -1.0)
    close = abs(scaled) < 20.0
    if any_of(close):
        sign = where(close, hyperbolic_tangent(scaled), sign)
    return sign
