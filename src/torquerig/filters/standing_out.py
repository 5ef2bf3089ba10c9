"""By how much each line stands out of the load beside it, and so how much of it is to be subtracted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.analysis.order_envelope import hop_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.filters.block_regression import Blocks
    from torquerig.orders.analysis.order_envelope import Hops

    Floats = NDArray[np.float64]

_STANDS_OUT = 4.0  # times the load beside it; noise alone is so high once in 50
_NEAREST, _FARTHEST = 2, 12  # bins beside a line, of 1 / block each, in which the load is judged
_FEWEST_HOPS = 4 * _FARTHEST  # below, the bins lie too near the edge of what hops can tell apart


def weights(rest: Floats, fitted: Floats, hops: Hops, orders: Floats, blocks: Blocks) -> Floats:
    """Return by how much of itself each line is to be subtracted in each block, shape (orders, blocks).

    Parameters
    ----------
    rest : ndarray, shape (samples,)
        What is left when all lines are subtracted whole.
    fitted : ndarray, shape (2, orders, blocks)
        The amplitudes of the lines.

    Notes
    -----
    The load beside a line is that of its bins 2 to 12 on either side, a bin being one period more in the block. It is
    read from the sums over hops, which turn each line back to rest: a transform of some hundred hops, with what
    a hop's mean takes off put back. Short blocks are transformed sample by sample.
    """
    power = (fitted**2).sum(axis=0)
    beside = np.empty_like(power)
    sums: NDArray[np.complex128] | None = None
    for index, (first, last) in enumerate(blocks.spans):
        if last - first < _FEWEST_HOPS:
            beside[:, index] = _by_samples(rest, hops, orders, first, last)
            continue
        if sums is None:
            in_phase, quadrature = hop_sums(rest, hops, orders)
            sums = in_phase - 1j * quadrature
        beside[:, index] = _by_hops(sums[:, first:last], hops, orders, first, last)
    return np.where(power > _STANDS_OUT * beside, 1 - beside / np.maximum(power, 1e-300), 0.0)


def _by_hops(sums: NDArray[np.complex128], hops: Hops, orders: Floats, first: int, last: int) -> Floats:
    """Mean power beside each line in one block, from the hop sums there, shape (orders, hops)."""
    count = last - first
    near = np.arange(_NEAREST, _FARTHEST + 1)
    offsets = np.concatenate([-near[::-1], near])
    turning = np.exp(-2j * np.pi * np.outer(np.arange(count) + 0.5, offsets) / count)
    samples = hops.edges[last] - hops.edges[first]
    power = np.abs(sums @ turning * (2 / samples)) ** 2 / np.sinc(offsets / count) ** 2
    turned = abs(hops.turns[hops.edges[last] - 1] - hops.turns[hops.edges[first]])
    # what would stand at or below no turning at all is the other side of the same bins
    inside = np.round(orders * turned)[:, None] + offsets > 0
    return np.asarray(np.where(inside, power, 0.0).sum(axis=1) / inside.sum(axis=1))


def _by_samples(rest: Floats, hops: Hops, orders: Floats, first: int, last: int) -> Floats:
    """Mean power beside each line in one block, from the spectrum of its samples."""
    from scipy.fft import prev_fast_len

    start = hops.edges[first]
    stop = start + prev_fast_len(int(hops.edges[last] - start), real=True)
    piece = rest[start:stop] - rest[start:stop].mean()
    spectrum = np.abs(np.fft.rfft(piece) * 2 / piece.size) ** 2
    turned = abs(hops.turns[stop - 1] - hops.turns[start])
    return np.array([_beside(spectrum, order * turned) for order in orders])


def _beside(spectrum: Floats, bin_of_line: float) -> float:
    """Mean power of the bins on both sides of a line; of fewer where the line stands near zero."""
    at = round(bin_of_line)
    near = [*range(max(at - _FARTHEST, 1), at - _NEAREST + 1), *range(at + _NEAREST, at + _FARTHEST + 1)]
    inside = [one for one in near if 0 < one < spectrum.size]
    return float(spectrum[inside].mean()) if inside else np.inf
