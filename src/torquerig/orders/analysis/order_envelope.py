"""The amplitude of each order line over the turns of a shaft: torque times the line's unit vector, averaged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.orders.line_sums.sums import order_sums, put_in

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

HOPS_PER_TURN = 8  # a whole number, so that lines that differ by whole orders fall on zeros of a hop's mean
_HIGHEST_SHARE_OF_RATE = 0.45


@dataclass(frozen=True)
class Hops:
    """Equal steps of the turned angle: ``edges`` (hops + 1,) in samples, ``turns`` of the motor at each sample."""

    edges: NDArray[np.int64]
    turns: Floats

    @property
    def fastest(self) -> float:
        """The largest step of the motor's angle from one sample to the next [turns]."""
        steps = np.diff(self.turns)
        return float(max(steps.max(initial=0.0), -steps.min(initial=0.0)))

    @property
    def turned(self) -> float:
        """The turns of the motor in either direction [turns]."""
        return float(np.abs(np.diff(self.turns)).sum())

    @property
    def samples(self) -> Floats:
        """The number of samples of each hop, shape (hops,)."""
        return np.diff(self.edges).astype(np.float64)


def hops_of(angle: Floats, *, ratio: float) -> Hops | None:
    """Return hops of an eighth of an output turn, or None where the shaft turns less than that.

    Parameters
    ----------
    angle : ndarray, shape (samples,)
        Of the motor [rad]; it may stop or turn back. One that falls on the whole is mirrored, so that a reversed
        recording has the same lines to the last digit.
    ratio : float
        Motor turns per output turn [1].
    """
    turns = angle / (2 * np.pi)
    if angle.size and angle[-1] < angle[0]:
        np.negative(turns, out=turns)
    turned = np.zeros(turns.size)
    steps = np.diff(turns)
    np.cumsum(np.abs(steps, out=steps), out=turned[1:])
    turned /= ratio
    count = round(float(turned[-1]) * HOPS_PER_TURN)
    if count < 1:
        return None
    inner = np.searchsorted(turned, np.arange(1, count) * (turned[-1] / count))
    edges = np.concatenate([[0], inner, [angle.size]]).astype(np.int64)
    return Hops(np.unique(edges), np.ascontiguousarray(turns))


def resolved_orders(orders: Sequence[float], fastest: float) -> Floats:
    """Return the distinct orders that stay below 0.45 periods a sample at ``fastest`` [turns per sample]."""
    unique = {f"{order:.9g}": order for order in orders}
    return np.array(sorted(order for order in unique.values() if order * fastest <= _HIGHEST_SHARE_OF_RATE))


def hop_sums(values: Floats, hops: Hops, orders: Floats) -> Floats:
    """Return sums of the values less their mean times cos and sin of each order over each hop, (2, orders, hops)."""
    return order_sums(values, hops.turns, orders, hops.edges, offset=float(values.mean()))


def without_lines(values: Floats, hops: Hops, orders: Floats, amplitudes: Floats) -> Floats:
    """Return the values less the lines whose amplitudes (2, orders, hops + 1) are given at the edges of the hops."""
    residual = np.array(values, dtype=np.float64)
    put_in(residual, hops.turns, orders, hops.edges, amplitudes, gain=-1.0)
    return residual


def envelope(sums: Floats, samples: Floats, window: int) -> Floats:
    """Return twice the Hann-weighted mean of the hop sums at each edge of the hops, shape (2, orders, hops + 1).

    Parameters
    ----------
    sums : ndarray, shape (2, orders, hops)
        Sums of the torque times cos and sin.
    samples : ndarray, shape (hops,)
        Samples per hop.
    window : int
        Length of the window [hops], even; limited to the number of hops.
    """
    count = samples.size
    window = min(window, count)
    weights = np.sin(np.pi * (np.arange(window) + 0.5) / window) ** 2
    below = np.convolve(samples, weights, mode="valid")
    above = np.array([[np.convolve(row, weights, mode="valid") for row in part] for part in sums])
    inner = 2 * above.reshape(2, sums.shape[1], -1) / below
    before = (count + 1 - inner.shape[2]) // 2
    return np.pad(inner, ((0, 0), (0, 0), (before, count + 1 - inner.shape[2] - before)), mode="edge")
