"""Unit vectors of order lines as products of two others: one product instead of a sine and a cosine."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_SAME = 1e-12  # relative difference of orders that count as equal: a thousandth of a degree after a million turns
LADDERS = 64  # that are kept: a filter needs the same one three times, the drives of a study have few


@dataclass(frozen=True)
class Ladder:
    """The two factors of each order's unit vector, in the given sequence.

    Parameters
    ----------
    orders : ndarray, shape (orders,)
    first, second : ndarray of int, shape (orders,)
        The rows whose unit vectors are multiplied; -1 where sine and cosine must be computed.
    """

    orders: NDArray[np.float64]
    first: NDArray[np.int64]
    second: NDArray[np.int64]


def ladder_of(orders: NDArray[np.float64]) -> Ladder:
    """Return for each order two earlier orders whose sum it is, or -1 where there are none.

    Parameters
    ----------
    orders : ndarray, shape (orders,)
        Multiples of the turned angle [1], in any sequence; only earlier orders are used as factors.
    """
    return _ladder_of(np.ascontiguousarray(orders, dtype=np.float64).tobytes())


@lru_cache(maxsize=LADDERS)
def _ladder_of(content: bytes) -> Ladder:
    orders = np.frombuffer(content).copy()
    first = np.full(orders.size, -1, dtype=np.int64)
    second = np.full(orders.size, -1, dtype=np.int64)
    for row, order in enumerate(orders):
        # the two nearest rows, so that products of products are fewest
        for low in range(row - 1, -1, -1):
            difference = np.abs(orders[: low + 1] - (order - orders[low]))
            if difference.min() <= _SAME * max(abs(order), 1.0):
                first[row], second[row] = low, int(np.argmin(difference))
                break
    return Ladder(orders, first, second)
