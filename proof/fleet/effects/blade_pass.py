"""Blade pass: one pulse of resistance per blade."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.response import sensed_per_torque
from proof.fleet.setting import Setting
from proof.fleet.train import Train, blades


@dataclass(frozen=True)
class BladePass(Effect):
    """Blades per turn, peak of a pulse [N m], phase [rad]."""

    kind: ClassVar[str] = "blade_pass"
    order: int
    amplitude: float
    phase: float

    def parameters(self) -> dict[str, float | None]:
        """Order and peak."""
        return {"order_output": float(self.order), "amplitude_Nm": self.amplitude}

    def places(self) -> tuple[Place, ...]:
        """Return the order of the blades."""
        return (Place("order", "output_shaft", float(self.order)),)

    def on_train(self, train: Train) -> Train:
        """Add the pulses to the resistance."""
        return train._replace(blade_table=train.blade_table + blades(self.order, self.amplitude, self.phase))


def draw_blade_pass(rng: np.random.Generator, setting: Setting) -> BladePass | None:
    """Draw 4 to 12 blades where the scenario has none."""
    if "baffles" in setting.rig.design.parts:
        return None
    order = int(rng.integers(4, 13))
    gain = abs(sensed_per_torque(setting.train, order * setting.rotation(), -1, speed=setting.output_speed))
    return BladePass(part=setting.rig.design.body, order=order, phase=float(rng.uniform(0.0, 2.0 * np.pi)),
                     amplitude=float(min(2.5 * setting.line_size(rng) / max(gain, 0.05), setting.torque)))  # fmt: skip
