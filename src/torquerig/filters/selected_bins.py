"""A few bins of a long signal's spectrum, and a signal from a few bins, faster than a full transform.

The samples are split into interleaved rows (a divisor of their number), which are transformed together; only the
selected bins are combined from the rows. This is the last stage of a mixed-radix transform, for few bins.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import ceil, floor
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]
    Bins = NDArray[np.complex128]

_ROWS = 64  # most rows; more are not faster
_FEWEST_SAMPLES = 2**16  # with fewer samples a full transform is as fast
_LARGEST_SHARE = 32  # with more bins than samples / 32 a full transform is as fast


def bins_at(values: Floats, wanted: NDArray[np.int64]) -> Bins:
    """Return ``rfft(values)[wanted]``.

    Parameters
    ----------
    values : ndarray, shape (samples,)
    wanted : ndarray of int, shape (bins,)
        0 to samples // 2.
    """
    rows = _rows_for(values.size, wanted.size)
    if rows == 1:
        return np.asarray(np.fft.rfft(values)[wanted])
    from scipy.fft import rfft

    length = values.size // rows
    dealt = rfft(np.ascontiguousarray(values).reshape(length, rows), axis=0)
    at = wanted % length
    mirrored = at > length // 2
    part = dealt[np.where(mirrored, length - at, at)]
    part[mirrored] = part[mirrored].conj()
    return np.asarray(np.einsum("br,br->b", part, _twiddles(wanted, rows, values.size)))


def signal_of(bins: Bins, wanted: NDArray[np.int64], samples: int) -> Floats:
    """Return ``irfft`` of a spectrum with ``bins`` at ``wanted`` and zeros elsewhere, shape (samples,).

    Parameters
    ----------
    bins : ndarray, shape (bins,)
    wanted : ndarray of int, shape (bins,)
        Distinct; 0 to samples // 2.
    samples : int
    """
    rows = _rows_for(samples, wanted.size)
    if rows == 1:
        spectrum = np.zeros(samples // 2 + 1, dtype=np.complex128)
        spectrum[wanted] = bins
        return np.asarray(np.fft.irfft(spectrum, n=samples))
    from scipy.fft import irfft

    length = samples // rows
    # bins at 0 and half the rate are their own mirror images and would be counted twice
    once = np.where((wanted == 0) | (2 * wanted == samples), 0.5, 1.0) * bins
    turned = once[:, None] * _twiddles(wanted, rows, samples).conj() / rows
    dealt = np.zeros((length // 2 + 1, rows), dtype=np.complex128)
    at = wanted % length
    mirror = (length - at) % length  # place of the mirror image
    np.add.at(dealt, at[at <= length // 2], turned[at <= length // 2])
    np.add.at(dealt, mirror[mirror <= length // 2], turned[mirror <= length // 2].conj())
    return np.asarray(irfft(dealt, n=length, axis=0, overwrite_x=True)).reshape(samples)


def bins_within(samples: int, rate: float, bands: Iterable[tuple[float, float]]) -> NDArray[np.int64]:
    """Return the distinct bins from low to high of each band, edges included, without the mean."""
    width = rate / samples
    # tolerance, so that a bin on a band edge belongs to the band
    edges = ((max(ceil(low / width - 1e-6), 1), floor(high / width + 1e-6)) for low, high in bands)
    inner = [np.arange(first, min(last, samples // 2) + 1) for first, last in edges]
    return np.unique(np.concatenate([np.empty(0, dtype=np.int64), *inner]))


def _twiddles(wanted: NDArray[np.int64], rows: int, samples: int) -> Bins:
    return np.asarray(np.exp(-2j * np.pi / samples * (np.outer(wanted, np.arange(rows)) % samples)))


def _rows_for(samples: int, wanted: int) -> int:
    if samples < _FEWEST_SAMPLES or wanted * _LARGEST_SHARE > samples:
        return 1
    return int(np.gcd(samples, _ROWS))
