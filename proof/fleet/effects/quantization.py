"""Quantization: codes coarser than the converter's data sheet says."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class Quantization(Effect):
    """Distance of two codes [V]."""

    kind: ClassVar[str] = "quantization"
    mechanical: ClassVar[bool] = False
    in_samples: ClassVar[bool] = True
    step: float

    def parameters(self) -> dict[str, float | None]:
        """Step."""
        return {"step_V": self.step}

    def places(self) -> tuple[Place, ...]:
        """Return the distance of two codes."""
        return (Place("distribution", "V", self.step, 0.02),)

    def on_codes(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Round to the codes."""
        return np.asarray(np.round(volts / self.step) * self.step)


def draw_quantization(rng: np.random.Generator, setting: Setting) -> Quantization | None:
    """Draw a step between twice the noise and half the torque's variation."""
    low = 2.0 * setting.noise
    high = max(0.5 * setting.level * setting.volts_per_Nm, 1.5 * low)
    return Quantization(part=setting.rig.design.sensor, step=float(low * (high / low) ** rng.random()))
