"""Low-passed Gaussian noise, for slow variations of loads and speeds."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray


def low_passed_noise(count: int, rate: float, cutoff: float, rng: np.random.Generator) -> NDArray[np.float64]:
    """Return Gaussian noise of unit variance through a second-order Butterworth low-pass, shape (count,).

    The filter runs at a rate that suits its cutoff and the result is interpolated, because a 1.5 Hz filter at 25 kHz
    would need a warm-up of as many samples as the recording has.
    """
    from scipy.signal import butter, sosfilt

    slow_rate = min(rate, 100 * cutoff)
    needed = int(count * slow_rate / rate) + 2
    warm = int(5 * slow_rate / cutoff)
    sections = butter(2, cutoff, fs=slow_rate, output="sos")
    noise = sosfilt(sections, rng.standard_normal(needed + warm))[warm:]
    # equivalent noise bandwidth of a second-order Butterworth low-pass: pi / (2 sqrt 2) of the cutoff
    scale = 1 / sqrt(2 * cutoff / slow_rate * pi / (2 * sqrt(2)))
    return np.asarray(np.interp(np.arange(count) / rate, np.arange(needed) / slow_rate, noise * scale))
