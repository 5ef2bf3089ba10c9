"""How the spectrum of a run changes in time: the power in half octaves, block by block, beside its median."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_BLOCK = 0.04  # [s], every half of which a new one begins
_AROUND = 4.0  # [s] long against what is looked for, short against a ramp
_LOWEST = 100.0  # [Hz]: a block holds four periods
_HIGHEST_SHARE = 0.48  # of the sample rate
_FEWEST = 32  # blocks
_NOTHING = 1e-9  # of the median power, below which a block holds nothing
_FINEST = 0.02  # of the logarithm: steadier than this is nothing that was measured
OVERLAP = 1.5  # blocks that tell as much as one alone
_GAUSS = 1.4826  # standard deviation of a normal variate over its median deviation

Normal = Callable[[Floats], tuple[float, float]]


def by_median(values: Floats) -> tuple[float, float]:
    """Return the median of the values, and the standard deviation by the median of the deviations from it."""
    middle = float(np.median(values))
    return middle, _GAUSS * float(np.median(np.abs(values - middle)))


def closest_half(values: Floats) -> tuple[float, float]:
    """Return the middle of the half of the values that lies closest together, and the standard deviation it tells.

    As robust as the median, and not pulled by a second state that takes nearly half of the time (the shortest half:
    Rousseeuw & Leroy 1988, Statistica Neerlandica 42). Half of a normal variate lies within 0.6745 spreads of its mean.
    """
    ordered = np.sort(values)
    half = ordered.size // 2 + 1
    across = ordered[half - 1 :] - ordered[: ordered.size - half + 1]
    at = int(np.argmin(across))
    return float(0.5 * (ordered[at] + ordered[at + half - 1])), float(across[at]) * _GAUSS / 2


@dataclass(frozen=True)
class ShortSpectra:
    """Block ``n`` reaches from sample ``n * hop`` to ``(n + 2) * hop``.

    Parameters
    ----------
    log : ndarray, shape (bands, blocks)
        Logarithm of the power over its median in time; 0 in blocks that were left out.
    low : ndarray, shape (bands,)
        Lower edge of each band [Hz]; the upper one is half an octave higher.
    hop : int
        Samples from block to block.
    counted : ndarray of bool, shape (blocks,)
        Those of the median and the spreads.
    """

    log: Floats
    low: Floats
    hop: int
    counted: NDArray[np.bool_]

    @cached_property
    def spread(self) -> Floats:
        """Standard deviation of each band from block to block, shape (bands,), by the median of the deviations."""
        return np.maximum(_GAUSS * np.median(np.abs(self.log[:, self.counted]), axis=1), _FINEST)

    def joint(self, values: Floats) -> Floats:
        """Return the mean over the bands, each weighed by its precision."""
        weight = 1 / self.spread**2
        return np.asarray(np.tensordot(weight, values, 1) / weight.sum())

    def over_spread(self, series: Floats, length: int, *, normal: Normal = by_median) -> Floats:
        """Return the means of ``length`` blocks in units of their spread, at the middle one, shape (blocks,).

        What is ``normal`` is told of the means that counted blocks alone make; the spread is not less than that of as
        many independent blocks.
        """
        middle, one = normal(series[self.counted])
        window = np.full(length, 1 / length)
        means = np.convolve(series - middle, window, "valid")
        whole = np.convolve(self.counted, window, "valid") > 1 - 0.5 / length
        spread = max(one, _FINEST) / np.sqrt(length / OVERLAP)
        if whole.any():
            spread = max(spread, normal(means[whole])[1])
        answer = np.zeros(series.size)
        answer[length // 2 : length // 2 + means.size] = means / spread
        return answer


def short_spectra(
    values: Floats,
    rate: float,
    *,
    without: Sequence[tuple[int, int]] = (),
    apart: Sequence[tuple[int, int]] = (),
    moving: bool = False,
) -> ShortSpectra | None:
    """Return the short spectra of ``values``; None where they are too short or sampled too slowly.

    Parameters
    ----------
    values : ndarray, shape (samples,)
    rate : float
        Of the samples [Hz].
    without, apart : sequence of (int, int)
        First sample and one past the last of moments whose blocks are left out, and of those that are compared with
        the median and do not count in it.
    moving : bool
        Whether the spectrum may change with the speed: the median is then taken over 4 s around each block.
    """
    from scipy.ndimage import median_filter

    hop = round(0.5 * _BLOCK * rate)
    low = _LOWEST * 2 ** (0.5 * np.arange(64))
    low = low[low * np.sqrt(2) < _HIGHEST_SHARE * rate]
    if low.size == 0 or values.size < _FEWEST * hop:
        return None
    log = _log_power(values, rate, hop, low)
    left_out, aside = (_touched(moments, hop, log.shape[1]) for moments in (without, [*without, *apart]))
    at = np.flatnonzero(~aside)
    if at.size < _FEWEST:
        return None
    if moving:
        filled = np.array([np.interp(np.arange(aside.size), at, band[at]) for band in log])
        log -= median_filter(filled, size=(1, round(_AROUND * rate / hop)), mode="nearest")
    else:
        log -= np.median(log[:, at], axis=1, keepdims=True)
    log[:, left_out] = 0.0
    return ShortSpectra(log, low, hop, ~aside)


def spectrogram(values: Floats, rate: float, hop: int) -> tuple[Floats, Floats]:
    """Return the power of blocks of ``2 hop`` samples under Hann windows, shape (blocks, bins), and the bins [Hz]."""
    blocks = sliding_window_view(values, 2 * hop)[::hop]
    beside = blocks - blocks.mean(axis=1, keepdims=True)
    power = np.abs(np.fft.rfft(beside * np.hanning(2 * hop), axis=1)) ** 2
    return np.asarray(power), np.asarray(np.fft.rfftfreq(2 * hop, 1 / rate), dtype=np.float64)


def _log_power(values: Floats, rate: float, hop: int, low: Floats) -> Floats:
    """Return the logarithm of the power in each half octave of each block, shape (bands, blocks)."""
    power, frequency = spectrogram(values, rate, hop)
    edges = np.searchsorted(frequency, [*low, low[-1] * np.sqrt(2)])
    summed = np.array([power[:, start:stop].sum(axis=1) for start, stop in pairwise(edges)])
    return np.asarray(np.log(np.maximum(summed, _NOTHING * np.median(summed, axis=1, keepdims=True) + 1e-300)))


def _touched(moments: Sequence[tuple[int, int]], hop: int, blocks: int) -> NDArray[np.bool_]:
    """Return which blocks reach into any of the moments."""
    answer = np.zeros(blocks, dtype=bool)
    for start, stop in moments:
        answer[max(start // hop - 1, 0) : stop // hop + 1] = True
    return answer
