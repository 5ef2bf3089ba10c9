"""In no library: a bridge contact ages, and the sensor's gain jumps for a while."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class GainJump(Effect):
    """V *= 1 + change for ``lasts`` [s], some times in a run."""

    kind: ClassVar[str] = "gain_jump"
    in_library: ClassVar[bool] = False
    change: float
    lasts: float
    count: int

    def parameters(self) -> dict[str, float | None]:
        """Change, duration and number."""
        return {"change": self.change, "lasts_s": self.lasts, "per_run": float(self.count)}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Let the gain jump."""
        gain = np.ones(volts.size)
        length = round(self.lasts * nominal.SAMPLE_RATE)
        for start in rng.integers(0, volts.size - length, self.count):
            gain[start : start + length] = 1.0 + self.change
        return np.asarray(volts * gain)


def draw_gain_jump(rng: np.random.Generator, setting: Setting, *, size: float) -> GainJump:
    """Draw 20 to 80 % more or less for 0.2 to 1.5 s."""
    change = between(0.2, 0.8, size=size) * float(rng.choice([-1.0, 1.0]))
    return GainJump(change, float(rng.uniform(0.2, 1.5)), int(rng.integers(2, 6)))
