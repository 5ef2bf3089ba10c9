"""The sign of a speed without its jump, and what the compiler may rearrange."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

FAST = {"contract", "arcp", "nsz", "afn"}
# not nnan and ninf: a run that blows up must be seen; not reassoc: vector sums over a handful of terms cost 4 %
# numba counts the users of every array that it takes out of a tuple; in a loop of this size it no longer sees that it
# need not, which costs ten times the run; without counting nothing may be allocated inside
UNCOUNTED: dict[str, Any] = {"_nrt": False}


@njit(fastmath=FAST, inline="always")
def direction(speed: float, inverse_smoothing: float) -> float:
    """Return the sign of a speed, smoothed as tanh."""
    scaled = speed * inverse_smoothing
    if scaled > 20.0:
        return 1.0
    if scaled < -20.0:
        return -1.0
    return np.tanh(scaled)
