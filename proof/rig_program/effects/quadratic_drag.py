"""Quadratic drag: the load grows with the square of the speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class QuadraticDrag(Effect):
    """Load torque += c omega abs(omega) [Nms2]."""

    kind: ClassVar[str] = "quadratic_drag"
    coefficient: float

    def parameters(self) -> dict[str, float | None]:
        """Return the coefficient."""
        return {"coefficient_Nms2": self.coefficient}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Add the drag to the wear part."""
        return machine._replace(drag=self.coefficient)


def draw_quadratic_drag(rng: np.random.Generator, setting: Setting, *, size: float) -> QuadraticDrag:
    """Draw 0.12 to 4 Nm at the fastest run of the plan."""
    fastest = max(run.motor_speed for run in setting.plan) / nominal.RATIO
    return QuadraticDrag(between(0.12, 4.0, size=size) / fastest**2)
