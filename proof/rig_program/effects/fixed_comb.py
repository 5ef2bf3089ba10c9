"""A comb of fixed frequency: pick-up or an alias with its harmonics, whatever the rig does."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class FixedComb(Effect):
    """V += sum_h a_h cos(2 pi h f t + phi_h), from the fundamental [Hz] up; amplitudes in V."""

    kind: ClassVar[str] = "pwm_aliasing"
    frequency: float
    amplitudes: tuple[float, ...]

    def parameters(self) -> dict[str, float | None]:
        """Frequency and amplitude of the fundamental."""
        return {"frequency_Hz": self.frequency, "amplitude_V": self.amplitudes[0]}

    def also_right(self) -> tuple[str, ...]:
        """Interference of the contract's other class has the same equation, harmonics included."""
        return ("mains_interference",)

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the comb."""
        time = np.arange(volts.size) / nominal.SAMPLE_RATE
        out = volts.copy()
        for h, amplitude in enumerate(self.amplitudes, start=1):
            out += amplitude * np.cos(2.0 * np.pi * h * self.frequency * time + rng.uniform(0.0, 2.0 * np.pi))
        return out
