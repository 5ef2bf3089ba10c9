"""Least-squares amplitudes of order lines in long blocks, from sums over hops, without a design matrix in memory."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.analysis.order_envelope import Hops, hop_sums
from torquerig.orders.line_sums.sums import gram_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_FEWEST_PERIODS = 2.0
_RIDGE = 1e-9


@dataclass(frozen=True)
class Blocks:
    """Blocks that overlap by half: ``spans`` (first hop, last hop + 1) of each."""

    spans: tuple[tuple[int, int], ...]


def blocks_of(hops: Hops, *, length: int) -> Blocks:
    """Return blocks of about ``length`` samples, cut at hops, as equal as possible; a shorter record is one block."""
    halves = max(2, round(2 * int(hops.edges[-1]) / length))
    cuts = np.searchsorted(hops.edges, np.linspace(0, hops.edges[-1], halves + 1))
    pairs = {(int(first), int(last)) for first, last in zip(cuts[:-2], cuts[2:], strict=True) if last > first}
    return Blocks(tuple(sorted(pairs)))


def block_amplitudes(values: Floats, hops: Hops, orders: Floats, blocks: Blocks) -> Floats:
    """Return the cosine and sine amplitudes of each order in each block, shape (2, orders, blocks), fitted jointly.

    A constant is fitted with them. The amplitudes are 0 in a block with fewer than two periods of the order.

    Notes
    -----
    The normal equations need sums of cos and sin of all sums and differences of orders. The speed is taken as constant
    within a hop of an eighth of a turn, whose sum then has a closed form (sinc).
    """
    if not orders.size:
        return np.zeros((2, 0, len(blocks.spans)))
    with_constant = np.concatenate([[0.0], orders])
    moments = hop_sums(values, hops, with_constant)
    amplitudes = np.zeros((2, orders.size, len(blocks.spans)))
    for index, (first, last) in enumerate(blocks.spans):
        # of a shaft that turns to and fro the range counts: there and back it meets the same angles
        turned = np.ptp(hops.turns[np.minimum(hops.edges[first : last + 1], hops.turns.size - 1)])
        rows = np.concatenate([[0], 1 + np.flatnonzero(orders * turned >= _FEWEST_PERIODS)])
        moment = moments[:, rows, first:last].sum(axis=2)
        solved = _solved(gram_of(hops.turns, with_constant[rows], hops.edges[first : last + 1]), moment)
        amplitudes[:, rows[1:] - 1, index] = solved[:, 1:]
    return amplitudes


def at_edges(amplitudes: Floats, hops: Hops, blocks: Blocks) -> Floats:
    """Return the amplitudes at the edges of the hops: linear from one block's middle to the next."""
    middles = [0.5 * (hops.edges[first] + hops.edges[last]) for first, last in blocks.spans]
    return np.array([[np.interp(hops.edges, middles, row) for row in part] for part in amplitudes]).reshape(
        2, amplitudes.shape[1], hops.edges.size
    )


def _solved(gram: Floats, moment: Floats) -> Floats:
    count = moment.shape[1]
    kept = np.delete(np.arange(2 * count), count)  # the sine of the constant is zero everywhere
    part = gram[np.ix_(kept, kept)]
    part = part + _RIDGE * np.trace(part) / kept.size * np.eye(kept.size)
    solution = np.zeros(2 * count)
    solution[kept] = np.linalg.solve(part, moment.ravel()[kept])
    return solution.reshape(2, count)
