"""In no library: short tones at random times that no angle and no clock explains."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class ToneBursts(Effect):
    """Bell-shaped bursts of a tone [Hz] of this length [s], so many in a second, each with a phase of its own."""

    kind: ClassVar[str] = "tone_bursts"
    in_library: ClassVar[bool] = False
    frequency: float
    amplitude: float
    length: float
    per_second: float

    def parameters(self) -> dict[str, float | None]:
        """Frequency, amplitude, length and rate."""
        return {
            "frequency_Hz": self.frequency,
            "amplitude_V": self.amplitude,
            "length_s": self.length,
            "per_s": self.per_second,
        }

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the bursts."""
        out = volts.copy()
        half = round(3.0 * self.length * nominal.SAMPLE_RATE)
        time = np.arange(-half, half + 1) / nominal.SAMPLE_RATE
        bell = self.amplitude * np.exp(-0.5 * (time / self.length) ** 2)
        for middle in rng.integers(half, volts.size - half, max(int(rng.poisson(self.per_second * run.duration)), 3)):
            phase = rng.uniform(0.0, 2.0 * np.pi)
            out[middle - half : middle + half + 1] += bell * np.cos(2.0 * np.pi * self.frequency * time + phase)
        return out


def draw_tone_bursts(rng: np.random.Generator, setting: Setting, *, size: float) -> ToneBursts:
    """Draw bursts of 400 to 3000 Hz, 10 to 80 ms long, one to six in a second, of 15 mV to 0.6 V."""
    return ToneBursts(
        frequency=float(rng.uniform(400.0, 3000.0)),
        amplitude=between(0.015, 0.6, size=size),
        length=float(0.01 * 8.0 ** rng.random()),
        per_second=float(rng.uniform(1.0, 6.0)),
    )
