"""Runs of known lines, tones and noise, without a rig."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import blocks_of
from torquerig.inference.measured_run import MeasuredRun
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

Floats = NDArray[np.float64]


def drawn_run(
    seed: int, *, speed: Floats, rate: float = 2000.0, orders: Mapping[float, float] | None = None,
    tones: Mapping[float, float] | None = None, noise: float = 0.1, level: float = 1.0, name: str = "run1",
) -> MeasuredRun:  # fmt: skip
    """Return a run at ``speed`` [rad/s], with amplitudes [N m] by motor order and by frequency [Hz]."""
    rng = np.random.default_rng(seed)
    angle = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1])) / rate])
    time = np.arange(speed.size) / rate
    torque = level + noise * rng.standard_normal(speed.size)
    for order, amplitude in (orders or {}).items():
        torque += amplitude * np.cos(order * angle + rng.uniform(0, 2 * pi))
    for frequency, amplitude in (tones or {}).items():
        torque += amplitude * np.cos(2 * pi * frequency * time + rng.uniform(0, 2 * pi))
    steady = bool(np.ptp(speed) < 1e-9)
    run = Run(speed=float(speed.max()), profile="steady" if steady else "ramp")
    channel = Channel(values=torque, quantity="torque", unit="V")
    return MeasuredRun(
        recording=Recording(sample_rate=rate, channels={"torque_V": channel}, run=run, name=name), torque=torque,
        angle=angle, speed=speed, has_encoder=True, speed_factor=1.0, blocks=blocks_of(speed),
    )  # fmt: skip


def steady(rpm: float, *, duration: float = 12.0, rate: float = 2000.0) -> Floats:
    """Return a constant speed [rad/s]."""
    return np.full(int(duration * rate), rpm * pi / 30)


def ramp(rpm: float, *, duration: float = 12.0, rate: float = 2000.0) -> Floats:
    """Return a speed from a tenth of ``rpm`` to ``rpm`` [rad/s]."""
    return np.linspace(0.1, 1.0, int(duration * rate)) * rpm * pi / 30
