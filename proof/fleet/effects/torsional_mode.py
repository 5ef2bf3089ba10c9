"""Torsional mode: a further inertia on a spring at the body of the load."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.setting import Setting
from proof.fleet.train import Train


@dataclass(frozen=True)
class TorsionalMode(Effect):
    """Branch of ``inertia`` [kg m^2], clamped ``frequency`` [Hz] and ``damping_ratio``."""

    kind: ClassVar[str] = "torsional_mode"
    frequency: float
    inertia: float
    damping_ratio: float

    def parameters(self) -> dict[str, float | None]:
        """Frequency, inertia and damping ratio of the clamped branch."""
        return {"frequency_Hz": self.frequency, "inertia_kgm2": self.inertia, "damping_ratio": self.damping_ratio}

    def places(self) -> tuple[Place, ...]:
        """Return the frequency."""
        return (Place("frequency", "Hz", self.frequency, 0.1),)

    def on_train(self, train: Train) -> Train:
        """Hang the branch on the last mass."""
        w = 2.0 * pi * self.frequency
        return train._replace(branch_inertia=self.inertia, branch_stiffness=self.inertia * w * w,
                              branch_damping=2.0 * self.damping_ratio * self.inertia * w)  # fmt: skip


def draw_torsional_mode(rng: np.random.Generator, setting: Setting) -> TorsionalMode | None:
    """Draw a branch between 8 Hz and a quarter of the sample rate, of 5 to 60 % of the body's inertia."""
    highest = min(0.4 * setting.nyquist, 150.0)
    return TorsionalMode(
        part=setting.rig.design.body,
        frequency=float(8.0 * (highest / 8.0) ** rng.random()),
        inertia=float(setting.train.inertia[-1] * 10.0 ** rng.uniform(-1.3, -0.2)),
        damping_ratio=float(rng.uniform(0.005, 0.03)),
    )
