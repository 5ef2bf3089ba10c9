"""The compiled part of a dry load near standstill: an element that slips."""

from __future__ import annotations

import numpy as np
from numba import njit


@njit(cache=True, nogil=True)
def elastic_plastic(twist, stiffness, forward, backward, start):
    """Return the torque after each step, shape (steps,), of an element that holds ``start`` before the first.

    Parameters
    ----------
    twist : ndarray, shape (steps,)
        What each step winds it up by [rad].
    stiffness : float
        [N m/rad].
    forward, backward : ndarray, shape (steps,)
        What it can hold either way [N m], both positive.
    """
    torque = np.empty(twist.size)
    held = start
    for step in range(twist.size):
        held = min(max(held + stiffness * twist[step], -backward[step]), forward[step])
        torque[step] = held
    return torque
