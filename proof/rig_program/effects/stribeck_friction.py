"""Stribeck friction: dry friction at the wear part that is larger near standstill, and may differ by direction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Profile, Run


@dataclass(frozen=True)
class StribeckFriction(Effect):
    """Tc + (Ts - Tc) exp(-(omega / ws)^2) for each direction: (Tc [Nm], Ts [Nm], ws [rad/s])."""

    kind: ClassVar[str] = "stribeck_friction"
    forward: tuple[float, float, float]
    backward: tuple[float, float, float]

    def parameters(self) -> dict[str, float | None]:
        """Coulomb and static torque and Stribeck speed, with suffixes where the directions differ."""
        names = ("coulomb_Nm", "static_Nm", "stribeck_rad_s")
        if self.forward == self.backward:
            return {**dict(zip(names, self.forward, strict=True))}
        both: dict[str, float | None] = {}
        for side, values in (("forward", self.forward), ("backward", self.backward)):
            both |= {f"{name}_{side}": value for name, value in zip(names, values, strict=True)}
        return both

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Make the wear part's bearing dry."""
        return machine._replace(dry=np.array([*self.forward, *self.backward]))


def draw_stribeck_friction(rng: np.random.Generator, setting: Setting, *, size: float) -> StribeckFriction:
    """Draw 0.06 to 1.5 Nm of Coulomb torque; directions differ in a third of the plans that reverse."""
    coulomb = between(0.06, 1.5, size=size)
    forward = (coulomb, coulomb * float(rng.uniform(1.15, 3.0)), float(0.2 * 20.0 ** rng.random()))
    reverses = any(run.profile is Profile.REVERSAL for run in setting.plan)
    if not reverses or rng.random() > 1.0 / 3.0:
        return StribeckFriction(forward, forward)
    factor = float(rng.choice([rng.uniform(0.4, 0.75), rng.uniform(1.35, 2.2)]))
    return StribeckFriction(forward, (factor * forward[0], factor * forward[1], forward[2]))
