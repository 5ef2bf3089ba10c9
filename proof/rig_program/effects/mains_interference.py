"""Mains interference: the grid's frequency and its harmonics on the sensor's cable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class MainsInterference(Effect):
    """V += sum over harmonics h of a_h cos(2 pi h f t + phi); ``lines`` holds (h, a_h [V])."""

    kind: ClassVar[str] = "mains_interference"
    frequency: float
    lines: tuple[tuple[int, float], ...]

    def parameters(self) -> dict[str, float | None]:
        """Frequency and amplitude of the fundamental."""
        return {"frequency_Hz": self.frequency, "amplitude_V": self.lines[0][1]}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the hum, with phases that no other run shares."""
        turn = 2.0 * np.pi * self.frequency * np.arange(volts.size) / nominal.SAMPLE_RATE + rng.uniform(0, 2 * np.pi)
        return np.asarray(volts + sum(a * np.cos(h * turn + 0.7 * h) for h, a in self.lines))


def draw_mains_interference(rng: np.random.Generator, setting: Setting, *, size: float) -> MainsInterference:
    """Draw a grid of 50 Hz (or 60) within its tolerance, up to 1 V, with odd harmonics or none."""
    frequency = float(rng.choice([50.0, 50.0, 50.0, 60.0]) * (1.0 + 6e-4 * rng.standard_normal()))
    low = just_visible(setting, lambda _: frequency, lambda *_: 1.0)
    first = between(1.5 * low, 1.0, size=size)
    lines = [(1, first)]
    lines += [(h, first * float(rng.uniform(0.05, 0.5))) for h in (2, 3, 5) if rng.random() < 0.5]
    return MainsInterference(frequency, tuple(lines))
