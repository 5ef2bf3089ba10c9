"""A wear rig's torque reading drawn at random, by formulas of its own: nothing of the package makes these signals.

The numbers are those of the reference wear rig: load, particle hits, lines of shafts, a torsional mode, the amplifier's
low-pass, white noise and a converter of 16 bits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import bessel, butter, sosfilt

Floats = NDArray[np.float64]

RATE = 25_000.0  # [Hz]
OCCUPANCIES, MEANS = (0.0, 5.0, 11.0, 15.0, 21.0), (0.05, 1.0, 2.0, 2.7, 3.8)  # [%], [N*m]
NOISE, RANGE, BITS = 0.005, 10.0, 16  # [V] rms, [V] either way, 1
MOTOR_ORDERS = (1, 2, 3, 4, 6, 7, 12, 14, 18, 21, 24, 28)
MOTOR_TORQUES = (0.020, 0.008, 0.004, 0.002, 0.020, 0.015, 0.008, 0.006, 0.005, 0.004, 0.003, 0.003)  # [N*m]
OUTPUT_TORQUES = (0.10, 0.04, 0.02, 0.01)  # [N*m], orders 1 to 4 of the output shaft at idle
RATIO = 5.0


@dataclass(frozen=True)
class Torque:
    """The torque in the sensor's spring before any electronics [N*m], and the angle of the output shaft [rad]."""

    values: Floats
    angle: Floats


def drawn_torque(
    rng: np.random.Generator, *, duration: float, profile: str = "steady", occupancy: float | None = None,
    particle: float | None = None, hits: float = 0.10,
) -> Torque:  # fmt: skip
    """Return the torque of a rig drawn by ``rng``, ``duration`` [s] long.

    Parameters
    ----------
    profile : {"steady", "ramp", "reversal"}
    occupancy : float, optional
        [%], drawn if None.
    particle : float, optional
        Size [mm], drawn if None.
    hits : float
        Rms of the particle hits over the mean load [1].
    """
    occupancy = float(rng.choice(OCCUPANCIES)) if occupancy is None else occupancy
    particle = float(rng.choice([0.3, 0.5, 1.0, 2.0])) if particle is None else particle
    samples = round(duration * RATE)
    speed = _speed(rng, profile, samples)
    angle = np.cumsum(speed) / RATE
    mean = float(np.interp(occupancy, OCCUPANCIES, MEANS)) * float(np.exp(0.05 * rng.standard_normal()))
    load = mean * (1 + 0.06 * slow(rng, samples, low_pass=1.5))
    load = np.maximum(load + hits * mean * unit_hits(rng, samples, occupancy, particle), 0.0)
    torque = load * np.tanh(speed / 0.02) + 0.01 * speed
    share = rng.uniform(0.3, 1.2)  # of the motor's ripple that reaches the sensor
    for order, size in zip(MOTOR_ORDERS, MOTOR_TORQUES, strict=True):
        torque += RATIO * share * _line(rng, size, order * RATIO * angle)
    for order, size in enumerate(OUTPUT_TORQUES, 1):
        torque += _line(rng, size / (1 + 0.12 * occupancy), order * angle)
    return Torque(ringing(torque, frequency=rng.uniform(80, 160), damping=rng.uniform(0.02, 0.08)), angle)


def _line(rng: np.random.Generator, size: float, phase: Floats) -> Floats:
    return np.asarray(size * np.exp(0.25 * rng.standard_normal()) * np.cos(phase + rng.uniform(0, 2 * np.pi)))


def _speed(rng: np.random.Generator, profile: str, samples: int) -> Floats:
    """Return the output shaft's speed [rad/s]."""
    full = float(rng.uniform(300, 2500)) * np.pi / 30 / RATIO * float(rng.choice([-1.0, 1.0]))
    time = np.linspace(0.0, 1.0, samples)
    if profile == "ramp":
        return np.asarray(full * np.minimum(0.1 + time, 1.0))
    if profile == "reversal":
        return np.asarray(full * np.sin(4 * np.pi * time))
    return np.asarray(full * (1 + 2e-4 * slow(rng, samples, low_pass=0.3)))


def slow(rng: np.random.Generator, samples: int, *, low_pass: float) -> Floats:
    """Return noise of unit rms below a frequency [Hz]."""
    step = max(int(RATE / (40 * low_pass)), 1)
    coarse = rng.standard_normal(samples // step + 800)
    coarse = sosfilt(butter(2, low_pass, fs=RATE / step, output="sos"), coarse)[400:]
    return np.asarray(np.interp(np.arange(samples) / step, np.arange(coarse.size), coarse / coarse.std()))


def unit_hits(rng: np.random.Generator, samples: int, occupancy: float, particle: float) -> Floats:
    """Return the pulses of particles less their mean, of unit rms."""
    rate = 60 * (0.5 / particle) ** 1.5 * (0.3 + occupancy / 10)
    decay = 0.004 * np.sqrt(particle / 0.5)
    struck = np.zeros(samples)
    count = rng.poisson(rate * samples / RATE)
    np.add.at(struck, rng.integers(0, samples, count), rng.gamma(1.5, 1.0, count))
    keep = np.exp(-1 / (decay * RATE))
    pulses = sosfilt([[1.0, 0.0, 0.0, 1.0, -keep, 0.0]], struck)
    return np.asarray((pulses - pulses.mean()) / max(float(pulses.std()), 1e-12))


def ringing(torque: Floats, *, frequency: float, damping: float) -> Floats:
    """Return the torque behind a torsional mode of a frequency [Hz] and damping ratio [1], bilinear."""
    warped = np.tan(np.pi * frequency / RATE)
    b = warped**2
    a = np.array([1 + 2 * damping * warped + b, 2 * (b - 1), 1 - 2 * damping * warped + b])
    start = torque[0]
    return np.asarray(sosfilt([[*(np.array([b, 2 * b, b]) / a[0]), *(a / a[0])]], torque - start) + start)


def amplified(volts: Floats, *, low_pass: float, kind: str) -> Floats:
    """Return the signal behind an amplifier of a kind ("butterworth", "bessel", "first order") and cut-off [Hz]."""
    if kind == "first order":
        sos = butter(1, low_pass, fs=RATE, output="sos")
    elif kind == "bessel":
        sos = bessel(2, low_pass, fs=RATE, output="sos", norm="mag")
    else:
        sos = butter(2, low_pass, fs=RATE, output="sos")
    return np.asarray(sosfilt(sos, volts - volts[0]) + volts[0])


def converted(rng: np.random.Generator, volts: Floats) -> Floats:
    """Return the samples: white noise is added and the converter rounds and stops at its limits."""
    step = 2 * RANGE / 2**BITS
    noisy = volts + NOISE * np.exp(0.3 * rng.standard_normal()) * rng.standard_normal(volts.size)
    return np.asarray(np.clip(step * np.round(noisy / step), -RANGE, RANGE - step))
