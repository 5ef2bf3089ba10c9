"""Cogging: magnets and teeth pull at whole orders of the motor, current or none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.effects.visible import just_visible, motor_frequency, unit_reading
from proof.rig_program.machine import MOTOR, Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import gain_of
from proof.rig_program.true_rig import Line
from proof.rig_program.waves import MOTOR_POINTS, sum_of


@dataclass(frozen=True)
class Cogging(Effect):
    """Torque [Nm] at the motor at whole orders; the largest line comes first."""

    kind: ClassVar[str] = "cogging"
    lines: tuple[Line, ...]

    def parameters(self) -> dict[str, float | None]:
        """Order and amplitude of the largest line."""
        return {"order_motor": float(self.lines[0].order), "amplitude_Nm": self.lines[0].amplitude}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Add the lines to the motor's ripple."""
        return machine._replace(motor_table=machine.motor_table + sum_of(self.lines, points=MOTOR_POINTS))


def draw_cogging(rng: np.random.Generator, setting: Setting, *, size: float) -> Cogging:
    """Draw native cogging of 12 slots and 14 magnets (order 84), or multiples that the nominal has not."""
    order = int(rng.choice([84, 84, 84, 36, 42, 56, 60]))
    at = motor_frequency(order)

    def gain(machine: Machine, frequency: float, _: Run) -> float:
        return nominal.RATIO * gain_of(machine, frequency, MOTOR)

    first = between(just_visible(setting, at, gain), min(0.8, 1.0 / unit_reading(setting, at, gain)), size=size)
    lines = [Line(order, first, float(rng.uniform(0.0, 2.0 * np.pi)))]
    if rng.random() < 0.5:
        lines.append(Line(2 * order, first * float(rng.uniform(0.1, 0.5)), float(rng.uniform(0.0, 2.0 * np.pi))))
    return Cogging(tuple(lines))
