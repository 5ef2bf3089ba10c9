"""Sensor bandwidth: the amplifier's low-pass lies lower than its data sheet says."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class SensorBandwidth(Effect):
    """True bandwidth [Hz]."""

    kind: ClassVar[str] = "sensor_bandwidth"
    mechanical: ClassVar[bool] = False
    cutoff: float

    def parameters(self) -> dict[str, float | None]:
        """Cut-off."""
        return {"cutoff_Hz": self.cutoff}

    def places(self) -> tuple[Place, ...]:
        """Return the band above the cut-off."""
        return (Place("frequency", "Hz", self.cutoff, 1.0),)

    def on_bandwidth(self, bandwidth: float) -> float:
        """Return the true bandwidth."""
        return self.cutoff


def draw_sensor_bandwidth(rng: np.random.Generator, setting: Setting) -> SensorBandwidth | None:
    """Draw 2 to 50 % of the stated bandwidth, where the torque has something to lose."""
    share = float(10.0 ** rng.uniform(-1.7, -0.3))
    return SensorBandwidth(part=setting.rig.design.sensor, cutoff=setting.bandwidth * share)
