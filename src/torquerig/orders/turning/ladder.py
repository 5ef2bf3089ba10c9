"""Which line's turning unit vector follows from two others': one product instead of a sine and a cosine."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_SAME = 1e-12  # orders that differ by less turn alike: a thousandth of a degree after a million turns


@dataclass(frozen=True)
class Ladder:
    """How to climb to each order, in the given sequence.

    Parameters
    ----------
    orders : ndarray, shape (orders,)
    first, second : ndarray of int, shape (orders,)
        The rows whose unit vectors are multiplied; -1 where the order's own sine and cosine are needed.
    """

    orders: NDArray[np.float64]
    first: NDArray[np.int64]
    second: NDArray[np.int64]


def ladder_of(orders: NDArray[np.float64]) -> Ladder:
    """Return how to have each order's unit vector from lower rows: the sum of two earlier orders, else by itself.

    Parameters
    ----------
    orders : ndarray, shape (orders,)
        Multiples of the turned angle [1]; any sequence, though only earlier ones serve later ones.
    """
    first = np.full(orders.size, -1, dtype=np.int64)
    second = np.full(orders.size, -1, dtype=np.int64)
    for row, order in enumerate(orders):
        # the rows nearest to each other: products of products are fewest
        for low in range(row - 1, -1, -1):
            rest = np.abs(orders[: low + 1] - (order - orders[low]))
            if rest.min() <= _SAME * max(abs(order), 1.0):
                first[row], second[row] = low, int(np.argmin(rest))
                break
    return Ladder(np.ascontiguousarray(orders, dtype=np.float64), first, second)
