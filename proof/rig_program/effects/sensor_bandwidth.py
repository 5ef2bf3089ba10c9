"""Sensor bandwidth: the amplifier's low-pass has a lower cut-off than its data sheet states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.machine import Machine
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class SensorBandwidth(Effect):
    """A second-order low-pass with corner [Hz] and damping ratio (0.707: Butterworth) instead of the data sheet's."""

    kind: ClassVar[str] = "sensor_bandwidth"
    cutoff: float
    damping: float

    def parameters(self) -> dict[str, float | None]:
        """Return the corner."""
        return {"cutoff_Hz": self.cutoff}

    def on_machine(self, machine: Machine, run: Run, rng: np.random.Generator) -> Machine:
        """Set the amplifier lower."""
        return machine._replace(amplifier=2.0 * np.pi * self.cutoff, amplifier_damping=self.damping)


def draw_sensor_bandwidth(rng: np.random.Generator, setting: Setting, *, size: float) -> SensorBandwidth:
    """Draw a corner between 450 Hz, just visible, and 40 Hz."""
    return SensorBandwidth(cutoff=between(40.0, 450.0, size=1.0 - size), damping=float(rng.uniform(0.66, 0.75)))
