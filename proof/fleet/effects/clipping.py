"""Clipping: the reading runs into a supply rail below the converter's range."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class Clipping(Effect):
    """Largest reading [V], plus and minus."""

    kind: ClassVar[str] = "clipping"
    mechanical: ClassVar[bool] = False
    in_samples: ClassVar[bool] = True
    limit: float

    def parameters(self) -> dict[str, float | None]:
        """Limit."""
        return {"limit_V": self.limit}

    def places(self) -> tuple[Place, ...]:
        """Return the level at which the reading ends."""
        return (Place("distribution", "V", self.limit, 0.02),)

    def on_codes(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Cut the reading."""
        return np.clip(volts, -self.limit, self.limit)


def draw_clipping(rng: np.random.Generator, setting: Setting) -> Clipping | None:
    """Draw a limit 0.5 to 2.5 standard deviations above the mean of the first run."""
    limit = (abs(setting.mean) + setting.level * float(rng.uniform(0.5, 2.5))) * setting.volts_per_Nm
    return Clipping(part=setting.rig.design.sensor, limit=float(limit))
