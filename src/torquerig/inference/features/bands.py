"""Spectral density of what the lines leave, in bands of equal width on a logarithmic scale."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.hann_window import hann_window

Floats = NDArray[np.float64]

BANDS_PER_OCTAVE = 6
_HIGHEST = 0.45  # of the sample rate
_NEXT, _NEXT_BUT_ONE = 4 / 9, 1 / 36  # squared correlation of the amplitudes of two bins under a Hann window


@dataclass(frozen=True)
class Bands:
    """Mean density of some blocks in each band.

    Parameters
    ----------
    low, high : ndarray, shape (bands,)
        Edges [Hz].
    power : ndarray, shape (bands,)
        One-sided density [(N m)^2/Hz]; NaN where the lines leave no bin.
    count : ndarray, shape (bands,)
        Independent values in the mean.
    block_power, block_count : ndarray, shape (blocks, bands)
        The same of each block.
    """

    low: Floats
    high: Floats
    power: Floats
    count: Floats
    block_power: Floats
    block_count: Floats

    @cached_property
    def middle(self) -> Floats:
        """Geometric mean of the edges [Hz]."""
        return np.sqrt(self.low * self.high)


def band_edges(rate: float, *, slowest: float) -> Floats:
    """Return the edges from ``slowest`` [Hz] on at ``rate`` samples per second [Hz], shape (bands + 1,).

    Runs of one rate have their edges at the same frequencies.
    """
    count = max(int(np.log2(_HIGHEST * rate / slowest) * BANDS_PER_OCTAVE), 1)
    return np.asarray(_HIGHEST * rate * 2 ** (np.arange(-count, 1) / BANDS_PER_OCTAVE))


def bands(residuals: Sequence[Floats], lines: Sequence[tuple[Floats, Floats]], rate: float, *, slowest: float) -> Bands:
    """Return the mean density of the residuals of some blocks [N m].

    Parameters
    ----------
    residuals : sequence of ndarray, shape (samples,)
    lines : sequence of (ndarray, ndarray)
        Of each block the frequencies of its lines [Hz] and the half-widths [Hz] around them that do not count.
    rate : float
        [Hz]
    slowest : float
        The lower end of the first band, or less than a band below it [Hz].
    """
    edges = band_edges(rate, slowest=slowest)
    shape = (len(residuals), edges.size - 1)
    total, used = np.zeros(shape), np.zeros(shape)
    for row, (residual, (frequency, half_width)) in enumerate(zip(residuals, lines, strict=True)):
        density, counts = _spectrum(residual, frequency, half_width, rate)
        step = rate / residual.size
        index = np.searchsorted(edges, np.arange(density.size) * step, side="right") - 1
        inside = counts & (index >= 0) & (index < edges.size - 1)
        total[row] = np.bincount(index[inside], weights=density[inside], minlength=edges.size - 1)
        used[row] = np.bincount(index[inside], minlength=edges.size - 1)
    count, whole = independent(used), used.sum(axis=0)
    return Bands(
        edges[:-1], edges[1:], power=_mean(total.sum(axis=0), whole), count=np.maximum(count.sum(axis=0), 1e-3),
        block_power=_mean(total, used), block_count=count,
    )  # fmt: skip


def _mean(total: Floats, used: Floats) -> Floats:
    return np.asarray(np.where(used > 0, total / np.maximum(used, 1.0), np.nan))


def independent(bins: Floats) -> Floats:
    """Return how many independent values a mean over neighbouring bins of a Hann window holds [1].

    The variance of a mean of N powers is ``(1 + 2 sum_k (1 - k/N) r_k^2) / N``, with ``r_1 = 2/3`` and ``r_2 = 1/6``
    the correlations of the amplitudes (Harris 1978, Proc. IEEE 66: overlap of the transform ``1/4, 1/2, 1/4``).
    """
    some = np.maximum(bins, 1.0)
    near = _NEXT * (1 - 1 / some) + _NEXT_BUT_ONE * np.maximum(1 - 2 / some, 0.0)
    return np.asarray(bins / (1 + 2 * near))


def _spectrum(residual: Floats, frequency: Floats, half_width: Floats, rate: float) -> tuple[Floats, NDArray[np.bool_]]:
    """Return the density of each bin of a block, its straight line removed, and which bins hold no line."""
    time = np.linspace(-1.0, 1.0, residual.size)
    slope = float(residual @ time) / float(time @ time)
    window = hann_window(residual.size)
    density = 2 * np.abs(np.fft.rfft((residual - residual.mean() - slope * time) * window)) ** 2
    density /= (window**2).sum() * rate
    counts = np.ones(density.size, dtype=bool)
    step = rate / residual.size
    for at, reach in zip(frequency.tolist(), half_width.tolist(), strict=True):
        counts[max(int(np.ceil((at - reach) / step)), 0) : int(np.floor((at + reach) / step)) + 1] = False
    counts[:2] = False  # the mean and what the window spreads of it
    return np.asarray(density), counts
