"""Backlash: a gap in the gear's spring, with the contact law of the case."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run

ARCMIN = np.pi / (180.0 * 60.0)


@dataclass(frozen=True)
class Backlash(Effect):
    """A full gap [arcmin] at the output."""

    kind: ClassVar[str] = "backlash"
    gap: float

    def parameters(self) -> dict[str, float | None]:
        """Return the full gap."""
        return {"gap_arcmin": self.gap}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Open the gap."""
        return machine._replace(half_gap=0.5 * self.gap * ARCMIN)


def draw_backlash(rng: np.random.Generator, setting: Setting, *, size: float) -> Backlash:
    """Draw a gap of 1 to 40 arcmin."""
    return Backlash(between(1.0, 40.0, size=size))
