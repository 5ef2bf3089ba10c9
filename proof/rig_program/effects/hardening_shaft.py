"""In no library: the sensor's shaft grows stiffer the more it is twisted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run
from proof.rig_program.transfer import resisting


@dataclass(frozen=True)
class HardeningShaft(Effect):
    """Torque k x (1 + b x^2) in the sensor's spring, x its twist [rad] and b [1/rad2]."""

    kind: ClassVar[str] = "hardening_shaft"
    in_library: ClassVar[bool] = False
    cubic: float

    def parameters(self) -> dict[str, float | None]:
        """Return the cubic coefficient."""
        return {"cubic_per_rad2": self.cubic}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Harden the spring."""
        return machine._replace(sensor_cubic=self.cubic)


def draw_hardening_shaft(rng: np.random.Generator, setting: Setting, *, size: float) -> HardeningShaft:
    """Draw a hardening that makes the spring 1.8 to 10 times as stiff at the plan's largest mean torque."""
    twist = max(resisting(setting.rig, run) for run in setting.plan) / setting.rig["sensor_stiffness"]
    return HardeningShaft(between(0.8, 9.0, size=size) / (3.0 * twist**2))
