"""Weights of lines by their power above the load near them: the share of each line that is subtracted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.analysis.order_envelope import hop_sums

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.filters.block_regression import Blocks
    from torquerig.orders.analysis.order_envelope import Hops

    Floats = NDArray[np.float64]

LEAST_RATIO = 4.0  # [1] power of a line over the load near it, at least; noise alone reaches it once in 50
_NEAREST, _FARTHEST = 2, 12  # bins of 1 / block on either side of a line, from which the load is estimated
_FEWEST_HOPS = 4 * _FARTHEST  # hops of a block, at least, so that these bins are well below half the hop rate


def weights(residual: Floats, fitted: Floats, hops: Hops, orders: Floats, blocks: Blocks) -> Floats:
    """Return the share of each line that is to be subtracted in each block [1], shape (orders, blocks).

    Parameters
    ----------
    residual : ndarray, shape (samples,)
        The torque less all fitted lines.
    fitted : ndarray, shape (2, orders, blocks)
        The amplitudes of the lines.

    Notes
    -----
    The load near a line is the mean power of the bins 2 to 12 on either side, where a bin is one period per block. It
    follows from the sums over hops, which demodulate each line: a transform of some hundred hops, corrected for the
    attenuation by the mean over a hop. Short blocks are transformed sample by sample.
    """
    power = (fitted**2).sum(axis=0)
    load = np.empty_like(power)
    sums: NDArray[np.complex128] | None = None
    for index, (first, last) in enumerate(blocks.spans):
        if last - first < _FEWEST_HOPS:
            load[:, index] = _by_samples(residual, hops, orders, first, last)
            continue
        if sums is None:
            in_phase, quadrature = hop_sums(residual, hops, orders)
            sums = in_phase - 1j * quadrature
        load[:, index] = _by_hops(sums[:, first:last], hops, orders, first, last)
    return np.where(power > LEAST_RATIO * load, 1 - load / np.maximum(power, 1e-300), 0.0)


def _by_hops(sums: NDArray[np.complex128], hops: Hops, orders: Floats, first: int, last: int) -> Floats:
    """Return the mean power near each line in one block, from its hop sums, shape (orders, hops)."""
    count = last - first
    near = np.arange(_NEAREST, _FARTHEST + 1)
    offsets = np.concatenate([-near[::-1], near])
    turning = np.exp(-2j * np.pi * np.outer(np.arange(count) + 0.5, offsets) / count)
    samples = hops.edges[last] - hops.edges[first]
    power = np.abs(sums @ turning * (2 / samples)) ** 2 / np.sinc(offsets / count) ** 2
    turned = abs(hops.turns[hops.edges[last] - 1] - hops.turns[hops.edges[first]])
    # bins at or below order 0 are mirror images of others
    inside = np.round(orders * turned)[:, None] + offsets > 0
    return np.asarray(np.where(inside, power, 0.0).sum(axis=1) / inside.sum(axis=1))


def _by_samples(residual: Floats, hops: Hops, orders: Floats, first: int, last: int) -> Floats:
    """Return the mean power near each line in one block, from the spectrum of its samples."""
    from scipy.fft import prev_fast_len

    start = hops.edges[first]
    stop = start + prev_fast_len(int(hops.edges[last] - start), real=True)
    piece = residual[start:stop] - residual[start:stop].mean()
    spectrum = np.abs(np.fft.rfft(piece) * 2 / piece.size) ** 2
    turned = abs(hops.turns[stop - 1] - hops.turns[start])
    return np.array([_power_near(spectrum, order * turned) for order in orders])


def _power_near(spectrum: Floats, bin_of_line: float) -> float:
    """Return the mean power of the bins on both sides of a line; of fewer bins where the line is near 0."""
    at = round(bin_of_line)
    near = [*range(max(at - _FARTHEST, 1), at - _NEAREST + 1), *range(at + _NEAREST, at + _FARTHEST + 1)]
    inside = [one for one in near if 0 < one < spectrum.size]
    return float(spectrum[inside].mean()) if inside else np.inf
