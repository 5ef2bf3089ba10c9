"""Torsional mode: a further inertia on a spring that hangs on the wear part."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import BRANCH, Machine, branch
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class TorsionalMode(Effect):
    """A branch with this inertia [kg m2]; its frequency [Hz] is that of the branch clamped at its root."""

    kind: ClassVar[str] = "torsional_mode"
    frequency: float
    inertia: float
    damping: float

    def parameters(self) -> dict[str, float | None]:
        """Frequency, inertia and damping ratio."""
        return {"frequency_Hz": self.frequency, "inertia_kgm2": self.inertia, "damping_ratio": self.damping}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Hang the branch on the wear part."""
        inertia, stiffness, damping = (
            x.copy() for x in (machine.inertia, machine.branch_stiffness, machine.branch_damping)
        )
        inertia[BRANCH] = self.inertia
        stiffness[0], damping[0] = branch(self.inertia, self.frequency, self.damping)
        return machine._replace(inertia=inertia, branch_stiffness=stiffness, branch_damping=damping)


def draw_torsional_mode(rng: np.random.Generator, setting: Setting, *, size: float) -> TorsionalMode:
    """Draw a branch of 25 to 350 Hz, from 3 % of the wear part's inertia to half more than the whole of it."""
    frequency = float(25.0 * 14.0 ** rng.random())
    least = 0.03 if frequency < 180.0 else 0.1
    return TorsionalMode(
        frequency=frequency,
        inertia=setting.rig["wear_inertia"] * between(least, 1.5, size=size),
        damping=float(0.003 * 25.0 ** rng.random()),
    )
