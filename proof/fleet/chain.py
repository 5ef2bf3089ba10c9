"""From the sensed torque to the file: low-pass, sensitivity, noise, converter; and the encoder or tacho."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def low_passed(torque: Floats, bandwidth: float, rate: float) -> Floats:
    """Return a torque (n,) behind a second-order Butterworth low-pass, exact for straight lines between frames."""
    from scipy.signal import cont2discrete, lfilter

    w = 2.0 * np.pi * bandwidth
    numerator, denominator, _ = cont2discrete(([w * w], [1.0, np.sqrt(2.0) * w, w * w]), 1.0 / rate, method="foh")
    start = torque[0]
    return np.asarray(start + lfilter(np.ravel(numerator), denominator, torque - start))


def noise(rng: np.random.Generator, samples: int, *, rms: float, colour: float) -> Floats:
    """Return noise (n,) of an rms [V], coloured by a first-order recursion."""
    from scipy.signal import lfilter

    white = rng.standard_normal(samples + 64)
    return np.asarray(rms * np.sqrt(1.0 - colour**2) * lfilter([1.0], [1.0, -colour], white)[64:])


def converted(volts: Floats, *, full: float, bits: int) -> Floats:
    """Return the codes of a converter in volts."""
    step = 2.0 * full / 2**bits
    half = 2 ** (bits - 1)
    return np.asarray(np.clip(np.round(volts / step), -half, half - 1) * step)


def encoder_counts(motor_angle: Floats, counts: int) -> NDArray[np.int64]:
    """Return the counts of an incremental encoder for its angle [rad]."""
    return np.floor(motor_angle * (counts / (2.0 * np.pi))).astype(np.int64)


def tacho_volts(motor_angle: Floats, pulses: int) -> Floats:
    """Return the pulses of a tacho wheel, high during half of each tooth."""
    return np.where(np.mod(motor_angle * pulses / (2.0 * np.pi), 1.0) < 0.5, 5.0, 0.0)
