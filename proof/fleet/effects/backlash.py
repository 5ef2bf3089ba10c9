"""Backlash: a gap in a gear's spring, with the contact law of the rig."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.setting import Setting
from proof.fleet.train import Train

ARCMIN = pi / (180.0 * 60.0)


@dataclass(frozen=True)
class Backlash(Effect):
    """A full ``gap`` [rad] at the output of spring ``spring``, whose shaft turns ``turns`` per output turn."""

    kind: ClassVar[str] = "backlash"
    spring: int
    gap: float
    turns: float

    def parameters(self) -> dict[str, float | None]:
        """Full gap."""
        return {"gap_arcmin": self.gap / ARCMIN}

    def places(self) -> tuple[Place, ...]:
        """Return that the distribution of torque and the speed near zero show it."""
        return (Place("speed", "rpm", 0.0, 1.0), Place("distribution", "V", 0.0, 1.0))

    def on_train(self, train: Train) -> Train:
        """Open the gap."""
        half = train.half_gap.copy()
        half[self.spring] = 0.5 * self.gap / self.turns
        return train._replace(half_gap=half)


def draw_backlash(rng: np.random.Generator, setting: Setting) -> Backlash | None:
    """Draw a gap of 1 to 60 arcmin in a gear whose torque passes zero; None where no run does that."""
    design = setting.rig.design
    reverses = any(run.profile == "reversal" for run in setting.rig.runs)
    if not design.stages or design.drive == "belt" or not (reverses or design.load_kind == "free"):
        return None
    spring = int(rng.integers(len(design.stages)))
    gap = ARCMIN * float(10.0 ** rng.uniform(0.0, 1.8))
    return Backlash(part=design.stages[spring].name, spring=spring, gap=gap, turns=abs(design.turns[spring + 1]))
