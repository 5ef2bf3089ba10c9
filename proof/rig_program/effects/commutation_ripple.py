"""Commutation: the motor's torque is not even over its turn, in proportion to itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible, motor_frequency, motor_torque
from proof.rig_program.machine import MOTOR, Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of
from proof.rig_program.true_rig import Line
from proof.rig_program.waves import MOTOR_POINTS, sum_of


@dataclass(frozen=True)
class CommutationRipple(Effect):
    """The motor's torque times 1 + d cos(k theta + phi) + harmonics of falling depth."""

    kind: ClassVar[str] = "commutation_ripple"
    order: int
    depths: tuple[float, ...]
    phases: tuple[float, ...]

    def parameters(self) -> dict[str, float | None]:
        """Order and depth of the first harmonic."""
        return {"order_motor": float(self.order), "depth": self.depths[0]}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Make the drive's torque uneven."""
        lines = [
            Line(h * self.order, depth, phase)
            for h, (depth, phase) in enumerate(zip(self.depths, self.phases, strict=True), start=1)
        ]
        return machine._replace(drive_table=sum_of(lines, points=MOTOR_POINTS))


def draw_commutation_ripple(rng: np.random.Generator, setting: Setting, *, size: float) -> CommutationRipple:
    """Draw ripple of six-step drives (six times the pole pairs, 42) or twice that, up to a depth of 0.6."""
    order = int(rng.choice([42, 42, 42, 42, 84]))
    low = just_visible(
        setting,
        motor_frequency(order),
        lambda machine, f, run: nominal.RATIO * gain_of(machine, f, MOTOR) * motor_torque(setting, run),
    )
    first = between(min(low, 0.4), 0.6, size=size)
    harmonics = int(rng.integers(1, 4))
    return CommutationRipple(
        order=order,
        depths=tuple(first * (1.0 if h == 1 else float(rng.uniform(0.1, 0.6)) / h) for h in range(1, harmonics + 1)),
        phases=tuple(float(x) for x in rng.uniform(0.0, 2.0 * np.pi, harmonics)),
    )
