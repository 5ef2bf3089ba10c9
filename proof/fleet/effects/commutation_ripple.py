"""Commutation ripple: motor torque that varies in proportion to itself, six times per electrical turn."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.response import sensed_per_torque
from proof.fleet.setting import Setting
from proof.fleet.train import ANGLE, Train


@dataclass(frozen=True)
class CommutationRipple(Effect):
    """Share ``depth`` of the motor torque at ``order`` of the motor, and ``second`` at twice that order."""

    kind: ClassVar[str] = "commutation_ripple"
    order: int
    depth: float
    second: float
    phase: float

    def parameters(self) -> dict[str, float | None]:
        """Order of the motor and depth."""
        return {"order_motor": float(self.order), "depth": self.depth}

    def places(self) -> tuple[Place, ...]:
        """Return the order on the motor shaft."""
        return (Place("order", "motor_shaft", float(self.order)),)

    def on_train(self, train: Train) -> Train:
        """Let the drive's torque vary with the motor angle."""
        wave = self.depth * np.cos(self.order * ANGLE + self.phase)
        wave += self.second * np.cos(2 * self.order * ANGLE + 2.0 * self.phase)
        return train._replace(drive_table=train.drive_table + wave)


def draw_commutation_ripple(rng: np.random.Generator, setting: Setting) -> CommutationRipple | None:
    """Draw a ripple of order 6p, or None where the motor has no commutation or the line lies above the sensor."""
    design = setting.rig.design
    if design.motor_kind == "induction":
        return None
    order = 6 * design.parts[design.motor]["pole_pairs"]
    frequency = order * setting.rotation(abs(design.ratio))
    if frequency > 1.5 * setting.bandwidth or frequency > 0.9 * setting.nyquist:
        return None
    gain = abs(sensed_per_torque(setting.train, frequency, 0, speed=setting.output_speed))
    depth = setting.line_size(rng) / gain / max(abs(setting.mean), 0.05 * setting.torque)
    depth = float(np.clip(depth, 0.003, 0.3))
    return CommutationRipple(part=design.motor, order=order, depth=depth, second=depth * float(rng.uniform(0.0, 0.3)),
                             phase=float(rng.uniform(0.0, 2.0 * pi)))  # fmt: skip
