"""Compiled loop: the straight path through a map along which its values sum to most."""

from __future__ import annotations

import numpy as np
from numba import njit
from numpy.typing import NDArray


@njit(cache=True, nogil=True)
def largest_path_sum(values: NDArray[np.float64], far: int) -> tuple[float, int, int]:
    """Return the largest sum along a straight path from the first row to the last, and the columns of its ends.

    Parameters
    ----------
    values : ndarray, shape (rows, columns)
    far : int
        Columns by which the ends of a path differ at least.
    """
    rows, columns = values.shape
    best, first, last = -np.inf, 0, 0
    for start in range(columns):
        for stop in range(columns):
            if abs(stop - start) < far:
                continue
            slope, total = (stop - start) / (rows - 1), 0.0
            for row in range(rows):
                total += values[row, int(start + slope * row + 0.5)]
            if total > best:
                best, first, last = total, start, stop
    return best, first, last
