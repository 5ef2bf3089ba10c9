"""Clipping: a stage of the measuring chain has a smaller range than the torque."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting
from proof.rig_program.plan import Run
from proof.rig_program.transfer import resisting, steady_runs


@dataclass(frozen=True)
class Clipping(Effect):
    """V = min(max(V, -limit), limit) [V]."""

    kind: ClassVar[str] = "clipping"
    limit: float

    def parameters(self) -> dict[str, float | None]:
        """Return the limit."""
        return {"limit_V": self.limit}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Cut the tops off."""
        return np.asarray(np.clip(volts, -self.limit, self.limit))


def draw_clipping(rng: np.random.Generator, setting: Setting, *, size: float) -> Clipping:
    """Draw a limit from 2.3 standard deviations above the mean of the most loaded run down to its mean."""
    run = max(steady_runs(setting.plan), key=lambda run: resisting(setting.rig, run))
    scatter = 0.1 + np.hypot(nominal.HITS_SHARE, nominal.SLOW_SHARE) * setting.rig.mean_load(run.occupancy)
    return Clipping(float(resisting(setting.rig, run) + (2.3 - 2.3 * size) * scatter))
