"""PWM aliasing: the drive's switching frequency, folded to a fixed frequency above the mechanical range."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class PwmAliasing(Effect):
    """Frequency as it appears [Hz], amplitude [V]."""

    kind: ClassVar[str] = "pwm_aliasing"
    mechanical: ClassVar[bool] = False
    frequency: float
    amplitude: float

    def parameters(self) -> dict[str, float | None]:
        """Frequency and amplitude."""
        return {"frequency_Hz": self.frequency, "amplitude_V": self.amplitude}

    def places(self) -> tuple[Place, ...]:
        """Return the frequency."""
        return (Place("frequency", "Hz", self.frequency),)

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the tone."""
        return np.asarray(
            volts + self.amplitude * np.cos(2.0 * np.pi * self.frequency * time + rng.uniform(0.0, 6.283))
        )


def draw_pwm_aliasing(rng: np.random.Generator, setting: Setting) -> PwmAliasing | None:
    """Draw a tone in the upper third of the recorded range, from one to thirty times the noise."""
    return PwmAliasing(
        part=setting.rig.design.sensor, frequency=float(setting.nyquist * rng.uniform(0.62, 0.97)),
        amplitude=setting.noise * float(10.0 ** rng.uniform(-0.5, 1.5)),
    )  # fmt: skip
