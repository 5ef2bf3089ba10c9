"""From the amplifier's output to the file: noise, converter and encoder."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal


def add_noise(
    volts: NDArray[np.float64], rng: np.random.Generator, *, rms: float, colour: float
) -> NDArray[np.float64]:
    """Add noise of this ``rms`` [V], coloured by a first-order recursion with this coefficient (0: white)."""
    white = rng.standard_normal(volts.size + 64)
    noise = white.copy()
    power = colour
    for lag in range(1, 33):  # impulse response of the recursion, truncated
        if abs(power) < 1e-9:
            break
        noise[lag:] += power * white[:-lag]
        power *= colour
    return np.asarray(volts + rms * np.sqrt(1.0 - colour**2) * noise[64:])


def convert(volts: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the converter's codes in volts: 16 bits over +-10 V."""
    step = 2.0 * nominal.CONVERTER_RANGE / 2**nominal.CONVERTER_BITS
    half = 2 ** (nominal.CONVERTER_BITS - 1)
    return np.asarray(np.clip(np.round(volts / step), -half, half - 1) * step)


def count(motor_angle: NDArray[np.float64]) -> NDArray[np.int32]:
    """Return the counts of the encoder on the motor for its angle [rad]."""
    return np.floor(motor_angle * (nominal.ENCODER_COUNTS / (2.0 * np.pi))).astype(np.int32)
