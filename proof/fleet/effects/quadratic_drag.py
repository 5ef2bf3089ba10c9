"""Quadratic drag: windage or stirring that the scenario does not have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.setting import Setting
from proof.fleet.train import Train


@dataclass(frozen=True)
class QuadraticDrag(Effect):
    """Coefficient [N m s^2/rad^2]."""

    kind: ClassVar[str] = "quadratic_drag"
    coefficient: float

    def parameters(self) -> dict[str, float | None]:
        """Coefficient."""
        return {"coefficient_Nms2": self.coefficient}

    def places(self) -> tuple[Place, ...]:
        """Return the level over speed."""
        return (Place("speed", "rpm", 0.0, 1.0), Place("level", "V", 0.0, 1.0))

    def on_train(self, train: Train) -> Train:
        """Add the drag."""
        return train._replace(drag=train.drag + self.coefficient)


def draw_quadratic_drag(rng: np.random.Generator, setting: Setting) -> QuadraticDrag | None:
    """Draw a drag of 5 to 60 % of the rated torque at the highest speed, where speeds differ and none is stated."""
    runs = setting.rig.runs
    speeds = {(run.speed, run.profile) for run in runs}
    if "flow" in setting.rig.design.parts or (len(speeds) < 2 and runs[0].profile == "steady"):
        return None
    share = float(10.0 ** rng.uniform(-1.3, -0.2))
    return QuadraticDrag(part=setting.rig.design.body, coefficient=share * setting.torque / setting.output_speed**2)
