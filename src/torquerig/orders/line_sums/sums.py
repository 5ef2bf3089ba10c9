"""Sums of a signal times order lines over stretches, lines added to a signal, and the Gram matrix of lines."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.line_sums.product_ladder import ladder_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def order_sums(
    values: Floats, turns: Floats, orders: Floats, edges: NDArray[np.int64], *, offset: float = 0.0
) -> Floats:
    """Return sums of ``values`` less ``offset`` times cos and sin of each order, shape (2, orders, stretches).

    Parameters
    ----------
    values, turns : ndarray, shape (samples,)
        The signal, and the turned angle [turns].
    orders : ndarray, shape (orders,)
        Multiples of that angle [1].
    edges : ndarray of int, shape (stretches + 1,)
        [samples]
    """
    from torquerig.orders.line_sums.kernel import summed

    ladder = ladder_of(orders)
    return np.asarray(
        summed(
            np.ascontiguousarray(values), float(offset), np.ascontiguousarray(turns), edges,
            ladder.orders, ladder.first, ladder.second,
        )
    )  # fmt: skip


def put_in(
    out: Floats, turns: Floats, orders: Floats, edges: NDArray[np.int64], amplitudes: Floats, *, gain: float
) -> None:
    """Add ``gain`` times the lines to ``out``; their ``amplitudes`` (2, orders, stretches + 1) at the edges."""
    from torquerig.orders.line_sums import kernel

    ladder = ladder_of(orders)
    kernel.put_in(
        out, np.ascontiguousarray(turns), edges, ladder.orders, ladder.first, ladder.second,
        np.ascontiguousarray(amplitudes), gain,
    )  # fmt: skip


def gram_of(turns: Floats, orders: Floats, edges: NDArray[np.int64]) -> Floats:
    """Return the Gram matrix of all cosines (first half) and sines (second half), shape (2 orders, 2 orders).

    The speed is taken as constant within each stretch, whose sum then has a closed form (sinc).
    """
    from torquerig.orders.line_sums.kernel import products

    start, stop = turns[edges[:-1]], turns[np.minimum(edges[1:], turns.size - 1)]
    size = np.diff(edges).astype(np.float64)
    # samples are at the start of each of `size` equal steps: their middle is half a step before that of the ends
    width = stop - start
    middle = start + 0.5 * width * (1 - 1 / size)
    plus_cos, plus_sin, minus_cos, minus_sin = products(middle, width, size, np.ascontiguousarray(orders))
    return 0.5 * np.block(
        [[minus_cos + plus_cos, plus_sin - minus_sin], [(plus_sin - minus_sin).T, minus_cos - plus_cos]]
    )


def adaptively_cancelled(values: Floats, turns: Floats, orders: Floats, step: float) -> Floats:
    """Return ``values`` less the lines predicted by adaptive amplitudes, updated by ``step`` per error (LMS)."""
    from torquerig.orders.line_sums.kernel import cancelled

    ladder = ladder_of(orders)
    return np.asarray(cancelled(values, turns, ladder.orders, ladder.first, ladder.second, step))
