"""A signal in overlapping frames and frequencies, by an orthonormal transform: what a likelihood of samples is made of.

The modified discrete cosine transform with a sine window: with N frequencies a frame, frames of 2 N samples that
overlap by half,

    X_k = sqrt(2 / N) sum_n sin(pi (n + 1/2) / 2 N) x_n cos(pi / N (n + 1/2 + N / 2) (k + 1/2))

All frames together are a rotation of the signal (Princen, Johnson & Bradley 1987, Proc. ICASSP). White noise therefore
stays white, sums of squares are those of the samples, and the window keeps lines from leaking over the whole spectrum.
Coloured noise has nearly independent coefficients whose variance is its two-sided density times the sample rate; true
where the density is smooth over 1 / (2 N) of the sample rate.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def lapped(values: Floats, bins: int, *, band: float) -> Floats:
    """Return the coefficients of a signal below ``band`` of its sample rate, shape (frames, kept bins).

    Parameters
    ----------
    values : ndarray, shape (samples,)
    bins : int
        N, the distance of two frames in samples.
    band : float
        Of the sample rate [1], at most 0.5.
    """
    count = frames_of(values.size, bins)
    frames = np.lib.stride_tricks.sliding_window_view(values[: (count + 1) * bins], 2 * bins)[::bins]
    return np.asarray(frames @ _waves(bins, kept_bins(bins, band)))


def frames_of(samples: int, bins: int) -> int:
    """Return how many frames fit."""
    return samples // bins - 1


def kept_bins(bins: int, band: float) -> int:
    """Return the number of frequencies below ``band`` of the sample rate."""
    return max(1, int(2 * band * bins))


def frequencies(bins: int, *, band: float, rate: float) -> Floats:
    """Return the frequency of each kept bin [Hz]."""
    return (np.arange(kept_bins(bins, band)) + 0.5) * rate / (2 * bins)


def from_lapped(coefficients: Floats, bins: int, samples: int) -> Floats:
    """Return the signal of coefficients, shape (samples,): the transpose of ``lapped``, its inverse below the band."""
    frames = coefficients @ _waves(bins, coefficients.shape[1]).T
    answer = np.zeros(samples)
    for row, frame in enumerate(frames):
        answer[row * bins : (row + 2) * bins] += frame
    return answer


@lru_cache(maxsize=16)
def _waves(bins: int, kept: int) -> Floats:
    time = np.arange(2 * bins) + 0.5
    window = np.sin(np.pi * time / (2 * bins))
    phase = np.pi / bins * np.outer(time + 0.5 * bins, np.arange(kept) + 0.5)
    return np.asarray(np.sqrt(2 / bins) * window[:, None] * np.cos(phase))
