"""Sensor drift: the zero walks away while a run is recorded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class SensorDrift(Effect):
    """V += s (1 - exp(-t / tau)), or s t / T over the recording where there is no tau [s]."""

    kind: ClassVar[str] = "sensor_drift"
    span: float
    time_constant: float | None

    def parameters(self) -> dict[str, float | None]:
        """Span and time constant, none where it is linear."""
        return {"span_V": self.span, "time_constant_s": self.time_constant}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Let the zero walk."""
        time = np.arange(volts.size) / nominal.SAMPLE_RATE
        if self.time_constant is None:
            return np.asarray(volts + self.span * time / run.duration)
        return np.asarray(volts + self.span * (1.0 - np.exp(-time / self.time_constant)))


def draw_sensor_drift(rng: np.random.Generator, setting: Setting, *, size: float) -> SensorDrift:
    """Draw a span of 0.12 to 3 V either way, exponential with 0.6 to 5 s or linear."""
    span = float(rng.choice([-1.0, 1.0])) * between(0.12, 3.0, size=size)
    return SensorDrift(span, None if rng.random() < 0.4 else float(0.6 * 8.0 ** rng.random()))
