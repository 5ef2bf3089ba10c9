"""A tone of fixed frequency above what shafts pass on: what an inverter's switching folds to, as large as it likes."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.spectrum import between_bins

Floats = NDArray[np.float64]

_FROM, _BESIDE = 400.0, 50.0  # [Hz] above what shafts pass on well, and either way of it
_STANDS_OUT = 1e4  # power over the median beside it: a smaller one hides neither limits nor jumps


def power_of(volts: Floats, rate: float) -> tuple[Floats, float]:
    """Return the power of a whole run under a Hann window, and the step of its frequencies [Hz]."""
    return np.abs(np.fft.rfft((volts - volts.mean()) * np.hanning(volts.size))) ** 2, rate / volts.size


def strongest_tone(power: Floats, step: float) -> float | None:
    """Return the frequency [Hz] of the strongest line where aliases stand, between the bins; None where none is.

    Parameters
    ----------
    power : ndarray, shape (bins,)
        Of a run under a Hann window.
    step : float
        Of its frequencies [Hz].
    """
    first = int(_FROM / step)
    if first + 1 >= power.size - 1:
        return None
    at, beside = first + int(np.argmax(power[first:-1])), max(int(_BESIDE / step), 1)
    near = power[max(at - beside, 0) : at + beside]
    return step * between_bins(power, at) if power[at] > _STANDS_OUT * np.median(near) else None


def without_tone(volts: Floats, rate: float) -> Floats | None:
    """Return the samples without that tone, its amplitude and phase straight in time; None where there is none."""
    frequency = strongest_tone(*power_of(volts, rate))
    if frequency is None:
        return None
    return without_waves(volts, rate, frequency, harmonics=1)


def without_waves(volts: Floats, rate: float, frequency: float, *, harmonics: int) -> Floats:
    """Return the samples [V] without a tone [Hz] and its harmonics, their amplitudes and phases straight in time."""
    waves = tone_waves(np.arange(volts.size) / rate, frequency, harmonics)
    left = volts - volts.mean()
    return np.asarray(volts - waves @ np.linalg.lstsq(waves.T @ waves, waves.T @ left, rcond=None)[0])


def tone_waves(time: Floats, frequency: float, harmonics: int) -> Floats:
    """Return the cosines and sines of a tone's harmonics, constant and straight in time, shape (samples, columns)."""
    phase = [2 * pi * frequency * harmonic * time for harmonic in range(1, harmonics + 1)]
    waves = np.column_stack([wave(angle) for angle in phase for wave in (np.cos, np.sin)])
    return np.hstack([waves, waves * np.linspace(-1.0, 1.0, time.size)[:, None]])
