"""The compiled part of the linear twin: responses between the points of their grid."""

from __future__ import annotations

import numpy as np
from numba import njit


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
