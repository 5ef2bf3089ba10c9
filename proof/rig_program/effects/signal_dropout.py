"""Signal dropout: a contact opens for milliseconds, and the voltage is something else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run

SLOT = 12.0  # [s] over which the number of dropouts is counted


@dataclass(frozen=True)
class SignalDropout(Effect):
    """V = level [V] for this duration [s], so many times in 12 s, scattered over them."""

    kind: ClassVar[str] = "signal_dropout"
    level: float
    duration: float
    count: int

    def parameters(self) -> dict[str, float | None]:
        """Duration and rate."""
        return {"duration_ms": 1000.0 * self.duration, "rate_per_minute": 60.0 * self.count / SLOT}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Open the contact, at least once in a run and never twice at a time."""
        out = volts.copy()
        length = round(self.duration * nominal.SAMPLE_RATE)
        count = max(round(self.count * run.duration / SLOT), 1)
        slot = volts.size / count
        for i in range(count):
            start = int(slot * i + rng.uniform(0.0, max(slot - 1.5 * length, 1.0)))
            out[start : start + length] = self.level
        return out


def draw_signal_dropout(rng: np.random.Generator, setting: Setting, *, size: float) -> SignalDropout:
    """Draw 1 to 60 ms, once to 18 times in 12 s, to zero or to a rail."""
    level = float(rng.choice([0.0, 0.0, -5.0, 9.9]))
    return SignalDropout(level, between(0.001, 0.06, size=size), round(18.0 ** rng.random()))
