"""Where a signal departs from its neighbourhood for some milliseconds, by a whitening matched filter."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.repair.pulse_behind_low_pass import LowPass, pulse_spectrum, window_size

Floats = NDArray[np.float64]

_SHAPES = ((0.004, 400.0), (0.010, 60.0))  # [s], [Hz]: short and sharp, long and round; others lie between
_WHITENED = 1e-3  # of the highest power: what is fainter is not raised
_HIGH_PASS, _FIRST = 4.0, 8.0  # [Hz] below which nothing counts; from which the highest power is sought
_LOCAL, _SMOOTHED, _QUIETEST = 1.0, 5, 0.3  # [s] of a local spread, how many are medianed, least share of the usual
_APART = 0.018  # [s] within which two departures are one


def short_departures(signal: Floats, rate: float, noise: Floats, *, least: float, most: int) -> NDArray[np.int64]:
    """Return the middles of the ``most`` largest departures, ``least`` robust spreads or more, the largest first.

    Parameters
    ----------
    signal : ndarray, shape (samples,)
    rate : float
        [Hz].
    noise : ndarray, shape (bins,)
        As of ``window_noise``.
    """
    size, frequency = np.zeros(signal.size), np.fft.rfftfreq(window_size(rate), 1 / rate)
    weight = 1 / (noise + _WHITENED * noise[frequency > _FIRST].max())
    for length, cutoff in _SHAPES:
        depth = depths(signal, rate, weight, length=length, low_pass=LowPass("butterworth", cutoff))
        shift = round(0.5 * length * rate)
        size[shift:] = np.maximum(size[shift:], _in_local_spreads(depth, rate)[: size.size - shift])
    return peaks_of(size, least=least, apart=max(round(_APART * rate), 1), shy=0.7, most=most)


def depths(signal: Floats, rate: float, weight: Floats, *, length: float, low_pass: LowPass) -> Floats:
    """Return how deep a pulse of a length [s] that begins at each sample would be, shape (samples,).

    ``weight`` is that of each frequency of a window, shape (bins,).
    """
    from scipy.fft import next_fast_len

    pad = min(window_size(rate), signal.size - 1)
    around = np.concatenate([2 * signal[0] - signal[pad:0:-1], signal, 2 * signal[-1] - signal[-2 : -pad - 2 : -1]])
    size = next_fast_len(around.size, real=True)
    frequency = np.asarray(np.fft.rfftfreq(size, 1 / rate), dtype=np.float64)
    weight = np.interp(frequency, np.fft.rfftfreq(window_size(rate), 1 / rate), weight)
    weight[frequency < _HIGH_PASS] = 0.0
    pulse = pulse_spectrum(frequency, length, low_pass, rate=rate)
    energy = 2 * float((np.abs(pulse) ** 2 * weight).sum()) / size
    matched = np.fft.irfft(np.fft.rfft(around - signal.mean(), size) * pulse.conj() * weight, size)
    return np.asarray(matched[pad : pad + signal.size] / energy)


def peaks_of(size: Floats, *, least: float, apart: int, shy: float, most: int) -> NDArray[np.int64]:
    """Return the largest peaks; within twice ``apart`` samples of one, only those that reach ``shy`` of it."""
    from scipy.signal import find_peaks

    found, _ = find_peaks(size, height=least)
    near, kept = np.zeros(size.size), list[int]()
    for at in found[np.argsort(-size[found])].tolist():
        if size[at] < near[at]:
            continue
        kept.append(at)
        if len(kept) >= most:
            break
        around, close = slice(max(at - 2 * apart, 0), at + 2 * apart), slice(max(at - apart, 0), at + apart)
        near[around] = np.maximum(near[around], shy * size[at])
        near[close] = np.inf
    return np.array(kept, dtype=np.int64)


def _in_local_spreads(depth: Floats, rate: float) -> Floats:
    from scipy.ndimage import median_filter

    block = max(round(_LOCAL * rate), 1)
    count = max(depth.size // block, 1)
    each = np.median(np.abs(depth[: count * block].reshape(count, -1)), axis=1) / 0.6745
    local = np.interp(
        np.arange(depth.size), (np.arange(count) + 0.5) * block, median_filter(each, _SMOOTHED, mode="nearest")
    )
    return np.asarray(np.abs(depth) / np.maximum(local, _QUIETEST * np.median(each) + 1e-300))
