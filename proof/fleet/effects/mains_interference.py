"""Mains interference: hum of 50 or 60 Hz with odd harmonics on the sensor's cable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class MainsInterference(Effect):
    """Frequency [Hz] and amplitudes [V] of the fundamental and of harmonics 2, 3 and 5."""

    kind: ClassVar[str] = "mains_interference"
    mechanical: ClassVar[bool] = False
    frequency: float
    amplitudes: tuple[float, ...]

    def parameters(self) -> dict[str, float | None]:
        """Frequency and amplitude of the fundamental."""
        return {"frequency_Hz": self.frequency, "amplitude_V": self.amplitudes[0]}

    def places(self) -> tuple[Place, ...]:
        """Return the fundamental."""
        return (Place("frequency", "Hz", self.frequency),)

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the hum."""
        for harmonic, size in zip((1, 2, 3, 5), self.amplitudes, strict=True):
            volts = volts + size * np.cos(
                2.0 * np.pi * harmonic * self.frequency * time + rng.uniform(0.0, 2.0 * np.pi)
            )
        return volts


def draw_mains_interference(rng: np.random.Generator, setting: Setting) -> MainsInterference | None:
    """Draw a hum of a mains whose frequency is off by up to 0.1 Hz."""
    first = setting.line_size(rng) * setting.volts_per_Nm
    shares = (1.0, *(float(rng.choice([0.0, rng.uniform(0.05, 0.4)])) for _ in range(3)))
    amplitudes = tuple(
        first * one if f * 60.0 < setting.nyquist else 0.0 for f, one in zip((1, 2, 3, 5), shares, strict=True)
    )
    frequency = float(rng.choice([50.0, 60.0])) + float(rng.uniform(-0.1, 0.1))
    return MainsInterference(part=setting.rig.design.sensor, frequency=frequency, amplitudes=amplitudes)
