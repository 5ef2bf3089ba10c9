"""In no library: the coupling slips now and then, and the shaft unwinds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting
from proof.rig_program.forcing import Forcing
from proof.rig_program.plan import Run
from proof.rig_program.transfer import resisting
from proof.rig_program.true_rig import TrueRig


@dataclass(frozen=True)
class IntermittentSlip(Effect):
    """For some milliseconds the coupling holds only a share of the mean torque; so often in a run."""

    kind: ClassVar[str] = "intermittent_slip"
    in_library: ClassVar[bool] = False
    share: float
    lasts: float
    count: int
    rig: TrueRig

    def parameters(self) -> dict[str, float | None]:
        """Share held, duration and number."""
        return {"share_held": self.share, "lasts_s": self.lasts, "per_run": float(self.count)}

    def on_forcing(self, forcing: Forcing, run: Run, rng: np.random.Generator) -> Forcing:
        """Let the coupling slip at random times of the recording."""
        limit = forcing.coupling_limit.copy()
        first = round(nominal.SETTLING * nominal.SAMPLE_RATE)
        length = round(self.lasts * nominal.SAMPLE_RATE)
        for start in rng.integers(first, forcing.samples - length, self.count):
            limit[start : start + length] = self.share * resisting(self.rig, run)
        return replace(forcing, coupling_limit=limit)


def draw_intermittent_slip(rng: np.random.Generator, setting: Setting, *, size: float) -> IntermittentSlip:
    """Draw slips that hold 75 to 15 % of the torque for 8 to 60 ms, 4 to 20 times in a run."""
    return IntermittentSlip(
        0.75 - 0.6 * size, float(0.008 * 7.5 ** rng.random()), int(rng.integers(4, 21)), setting.rig
    )
