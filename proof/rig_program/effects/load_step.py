"""In no library: the load steps up or down at a random time, and perhaps back."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.forcing import Forcing, recorded_time
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class LoadStep(Effect):
    """Load torque += step [Nm] from some time in each run on, for ``lasts`` [s] or to its end."""

    kind: ClassVar[str] = "load_step"
    in_library: ClassVar[bool] = False
    step: float
    lasts: float | None

    def parameters(self) -> dict[str, float | None]:
        """Step and how long it lasts."""
        return {"step_Nm": self.step, "lasts_s": self.lasts}

    def on_forcing(self, forcing: Forcing, run: Run, rng: np.random.Generator) -> Forcing:
        """Let the load step within 5 ms."""
        since = recorded_time(forcing.samples) - float(rng.uniform(0.2, 0.75)) * run.duration
        rise = np.clip(since / 0.005, 0.0, 1.0)
        if self.lasts is not None:
            rise = rise - np.clip((since - self.lasts) / 0.005, 0.0, 1.0)
        return replace(forcing, load=np.maximum(forcing.load + self.step * rise, 0.0))


def draw_load_step(rng: np.random.Generator, setting: Setting, *, size: float) -> LoadStep:
    """Draw steps of 0.3 to 3 Nm upwards, lasting 0.5 to 3 s or to the end."""
    return LoadStep(between(0.3, 3.0, size=size), None if rng.random() < 0.5 else float(rng.uniform(0.5, 3.0)))
