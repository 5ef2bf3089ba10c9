"""Sensor drift: the zero moves while the sensor warms up, from the beginning of each recording."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class SensorDrift(Effect):
    """Span [V] and time constant [s]; None: a straight line."""

    kind: ClassVar[str] = "sensor_drift"
    mechanical: ClassVar[bool] = False
    span: float
    time_constant: float | None

    def parameters(self) -> dict[str, float | None]:
        """Span and time constant."""
        return {"span_V": self.span, "time_constant_s": self.time_constant}

    def places(self) -> tuple[Place, ...]:
        """Return the course of the level over time."""
        return (Place("time", "s", 0.0, 1.0),)

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Add the drift."""
        if self.time_constant is None:
            return np.asarray(volts + self.span * time / (time[-1] + time[1]))
        return np.asarray(volts + self.span * (1.0 - np.exp(-time / self.time_constant)))


def draw_sensor_drift(rng: np.random.Generator, setting: Setting) -> SensorDrift | None:
    """Draw a drift of 1 to 20 % of the rated torque."""
    span = (
        setting.torque * float(10.0 ** rng.uniform(-2.0, -0.7)) * setting.volts_per_Nm * float(rng.choice([-1.0, 1.0]))
    )
    length = max(run.duration for run in setting.rig.runs)
    constant = None if rng.random() < 0.4 else length * float(rng.uniform(0.1, 0.8))
    return SensorDrift(part=setting.rig.design.sensor, span=span, time_constant=constant)
