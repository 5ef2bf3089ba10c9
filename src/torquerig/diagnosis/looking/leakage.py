"""What leaks from slow noise into the fast lines of a stretch that no window tapers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_BESIDE = 12  # bins on either side of what a line sweeps over, in which a density is taken
_LEAKS = 3.0  # times the density under a Hann window: less is chance, as both are means over some 20 bins


def leaked(rest: Floats, rate: float, lines: Sequence[tuple[float, float]]) -> Floats:
    """Return the density of ``rest`` beside each line where it is leakage [square of its unit per Hz]; else 0.

    A stretch ends elsewhere than it begins, which makes a spectrum that falls by 6 dB an octave, whatever the signal
    does there (Harris 1978, Proc. IEEE 66(1), on windows). Under a Hann window it falls by 18: where the density
    without one is several times as high, that is what a line's amplitude is uncertain by.

    Parameters
    ----------
    rest : ndarray, shape (samples,)
        Of a regression of lines, without a window.
    rate : float
        [Hz].
    lines : sequence of (float, float)
        Lowest and highest frequency of each line in the stretch [Hz].
    """
    from scipy.fft import next_fast_len

    if not lines:
        return np.zeros(0)
    window, points = np.hanning(rest.size), next_fast_len(rest.size, real=True)
    plain = _summed(rest, points, 2 / rate / rest.size)
    tapered = _summed(rest * window, points, 2 / rate / float((window**2).sum()))
    bins = np.array(lines) * points / rate
    low = np.clip(np.floor(bins.min(axis=1)).astype(int) - _BESIDE, 1, plain.size - 2)
    high = np.clip(np.ceil(bins.max(axis=1)).astype(int) + _BESIDE, low + 1, plain.size - 1)
    without, under = (plain[high] - plain[low]) / (high - low), (tapered[high] - tapered[low]) / (high - low)
    return np.asarray(np.where(without > _LEAKS * under, without, 0.0))


def _summed(values: Floats, points: int, unit: float) -> Floats:
    """Return the one-sided density of the values, summed up over its bins."""
    return np.concatenate([[0.0], np.cumsum(unit * np.abs(np.fft.rfft(values, points)) ** 2)])
