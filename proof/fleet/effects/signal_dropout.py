"""Signal dropout: the reading is lost for milliseconds, at random instants."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class SignalDropout(Effect):
    """Length [s], rate [1/min] and level [V]."""

    kind: ClassVar[str] = "signal_dropout"
    mechanical: ClassVar[bool] = False
    in_samples: ClassVar[bool] = True
    duration: float
    rate: float
    level: float

    def parameters(self) -> dict[str, float | None]:
        """Length and rate."""
        return {"duration_ms": 1e3 * self.duration, "rate_per_minute": self.rate}

    def places(self) -> tuple[Place, ...]:
        """Return that single instants show it."""
        return (Place("time", "s", 0.0, 1.0), Place("distribution", "V", self.level, 0.05))

    def on_codes(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Overwrite the lost samples; a run has at least one."""
        answer = volts.copy()
        length = max(round(self.duration / time[1]), 1)
        count = max(int(rng.poisson(self.rate / 60.0 * time[-1])), 1)
        for start in rng.integers(0, max(volts.size - length, 1), count):
            answer[start : start + length] = self.level
        return answer


def draw_signal_dropout(rng: np.random.Generator, setting: Setting) -> SignalDropout | None:
    """Draw 10 to 80 dropouts per minute of 2 to 40 ms, of at least two samples."""
    least = 2.5 / (2.0 * setting.nyquist)
    duration = max(float(10.0 ** rng.uniform(-2.7, -1.4)), least)
    sensor = setting.rig.design.parts[setting.rig.design.sensor]
    rail = float(sensor["converter_range"].split()[0])
    return SignalDropout(part=setting.rig.design.sensor, duration=duration, rate=float(rng.uniform(10.0, 80.0)),
                         level=float(rng.choice([0.0, 0.0, -rail])))  # fmt: skip
