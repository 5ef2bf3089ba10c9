"""Gear mesh: transmission error of a stage whose scenario has none, with a harmonic and side lines."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.response import sensed_per_error
from proof.fleet.setting import Setting
from proof.fleet.train import ANGLE, Train


@dataclass(frozen=True)
class GearMesh(Effect):
    """Error [rad of the stage's output shaft] of the teeth of spring ``spring``."""

    kind: ClassVar[str] = "gear_mesh"
    spring: int
    order: int
    size: float
    second: float
    phase: float
    modulation: float
    turns: float
    at_sensor: float

    def parameters(self) -> dict[str, float | None]:
        """Order on the shaft of the stage and on the output shaft, error, and line at the sensor in the fastest run."""
        return {"order_output": float(self.order), "transmission_error_rad": self.size, "amplitude_Nm": self.at_sensor}

    def places(self) -> tuple[Place, ...]:
        """Return the order of the teeth on the last shaft."""
        return (Place("order", "output_shaft", self.order * self.turns),)

    def on_train(self, train: Train) -> Train:
        """Add the error to the stage's table."""
        factor = 1.0 + self.modulation * np.cos(ANGLE)
        slow = -self.modulation * np.sin(ANGLE)
        errors, slopes, has_error = train.errors.copy(), train.slopes.copy(), train.has_error.copy()
        for order, size in ((self.order, self.size), (2 * self.order, self.second)):
            wave = size * np.cos(order * ANGLE + self.phase)
            errors[self.spring] += wave * factor / self.turns
            slopes[self.spring] += -size * order * np.sin(order * ANGLE + self.phase) * factor + wave * slow
        has_error[self.spring] = True
        return train._replace(errors=errors, slopes=slopes, has_error=has_error)


def draw_gear_mesh(rng: np.random.Generator, setting: Setting) -> GearMesh | None:
    """Draw a mesh of a toothed stage without one, or None."""
    design = setting.rig.design
    free = [i for i, one in enumerate(design.stages) if one.mesh_order and f"{one.name}_mesh" not in design.parts]
    free = [
        i for i in free if design.stages[i].mesh_order * setting.rotation(abs(design.turns[i + 1])) < setting.nyquist
    ]
    if not free:
        return None
    spring = int(rng.choice(free))
    stage = design.stages[spring]
    turns = abs(design.turns[spring + 1])
    frequency = stage.mesh_order * setting.rotation(turns)
    gain = abs(sensed_per_error(setting.train, frequency, spring, speed=setting.output_speed))
    at_sensor = setting.line_size(rng)
    size = min(at_sensor / gain * turns, 0.02 / stage.mesh_order)
    return GearMesh(
        part=stage.name, spring=spring, order=stage.mesh_order, size=size, second=size * float(rng.uniform(0.0, 0.4)),
        phase=float(rng.uniform(0.0, 2.0 * pi)), modulation=float(rng.choice([0.0, rng.uniform(0.1, 0.4)])),
        turns=turns, at_sensor=size / turns * gain,
    )  # fmt: skip
