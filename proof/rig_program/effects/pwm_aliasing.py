"""PWM aliasing: a line of the inverter's switching, folded to a frequency that no speed changes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class PwmAliasing(Effect):
    """V += a cos(2 pi f t + phi) at the frequency [Hz] as it appears."""

    kind: ClassVar[str] = "pwm_aliasing"
    frequency: float
    amplitude: float

    def parameters(self) -> dict[str, float | None]:
        """Frequency as it appears, and amplitude."""
        return {"frequency_Hz": self.frequency, "amplitude_V": self.amplitude}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Add the line."""
        turn = 2.0 * np.pi * self.frequency * np.arange(volts.size) / nominal.SAMPLE_RATE
        return np.asarray(volts + self.amplitude * np.cos(turn + rng.uniform(0.0, 2.0 * np.pi)))


def draw_pwm_aliasing(rng: np.random.Generator, setting: Setting, *, size: float) -> PwmAliasing:
    """Draw a line from 1.7 to 12 kHz, well above what the rig's shafts make, of 1 mV to 0.5 V."""
    return PwmAliasing(float(rng.uniform(1700.0, 12000.0)), between(1.0e-3, 0.5, size=size))
