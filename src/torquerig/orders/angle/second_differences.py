"""The banded matrix of a penalty on squared second differences (Whittaker smoother)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def second_difference_bands(size: int) -> NDArray[np.float64]:
    """Return the upper bands of D'D, shape (3, size), in the layout of ``scipy.linalg.solveh_banded``.

    D is the matrix of second differences, shape (size - 2, size); the last row of the result is the diagonal.
    """
    bands = np.zeros((3, size))
    row = (1.0, -2.0, 1.0)
    for i in range(3):
        for j in range(i, 3):
            bands[2 - (j - i), j : size - 2 + j] += row[i] * row[j]
    return bands


def times_bands(bands: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the symmetric matrix of three upper ``bands`` times a vector, shape (size,)."""
    product = np.asarray(bands[2] * values)
    for offset in (1, 2):
        band = bands[2 - offset, offset:]
        product[:-offset] += band * values[offset:]
        product[offset:] += band * values[:-offset]
    return np.asarray(product)
