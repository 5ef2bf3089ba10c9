"""The compiled parts of the linear twin: responses between the points of their grid, and an element that slips."""

from __future__ import annotations

from math import atanh

import numpy as np
from numba import njit

_SATURATED = 4.0  # times the smoothing: at this speed 99.9 % of the torque are held
_HALVINGS = 20  # of the range of the share: to 2e-6


@njit(cache=True, nogil=True)
def between_points(table, grid, which, at):
    """Return responses off their grid, shape (n, points): straight between its points.

    Parameters
    ----------
    table : ndarray, shape (responses, grid points)
        Complex.
    grid : ndarray, shape (grid points,)
        Ascending.
    which : ndarray, shape (n,)
        The response that each row is of.
    at : ndarray, shape (n, points)
        Within the grid; neighbours in a row most often lie between the same two points.
    """
    answer = np.empty(at.shape, dtype=np.complex128)
    low = 0
    for row in range(at.shape[0]):
        response = table[which[row]]
        for column in range(at.shape[1]):
            where = at[row, column]
            if not grid[low] < where <= grid[low + 1]:
                low, left = 0, grid.size - 1
                while left > 1:
                    half = left // 2
                    low += half if grid[low + half] < where else 0
                    left -= half
            share = (where - grid[low]) / (grid[low + 1] - grid[low])
            answer[row, column] = response[low] + (response[low + 1] - response[low]) * share
    return answer


@njit(cache=True, nogil=True)
def smoothed_share(steps, softness, start):
    """Return the share held after each step, shape (steps,), from -1 to 1, of an element that slips softly.

    Implicit Euler steps of ``y + softness artanh(y) = y_before + step``, by bisection.

    Parameters
    ----------
    steps : ndarray, shape (steps,)
        Of the motor's angle, over the angle by which the full torque winds the springs up [1].
    softness : float
        What the shaft turns in a step at the speed of its smoothing, over the same angle [1].
    start : float
        The share held before.
    """
    share = np.empty(steps.size)
    held = start
    for step in range(steps.size):
        asked = held + steps[step]
        if abs(asked) > 1 + _SATURATED * softness:
            held = np.sign(asked)
        else:
            low, high = -1.0, 1.0
            for _ in range(_HALVINGS):
                middle = 0.5 * (low + high)
                if middle + softness * atanh(middle) < asked:
                    low = middle
                else:
                    high = middle
            held = 0.5 * (low + high)
        share[step] = held
    return share
