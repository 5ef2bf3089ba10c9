"""In no library: the zero jumps between two levels at random times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run


@dataclass(frozen=True)
class Telegraph(Effect):
    """V += jump [V] or nothing; it stays for ``dwell`` [s] on average."""

    kind: ClassVar[str] = "telegraph"
    in_library: ClassVar[bool] = False
    jump: float
    dwell: float

    def parameters(self) -> dict[str, float | None]:
        """Jump and dwell."""
        return {"jump_V": self.jump, "dwell_s": self.dwell}

    def on_voltage(self, volts: NDArray[np.float64], run: Run, rng: np.random.Generator) -> NDArray[np.float64]:
        """Let the zero jump."""
        flips = rng.random(volts.size) < 1.0 / (self.dwell * nominal.SAMPLE_RATE)
        flips[rng.integers(volts.size // 4, 3 * volts.size // 4)] = True
        return np.asarray(volts + self.jump * (np.cumsum(flips) % 2))


def draw_telegraph(rng: np.random.Generator, setting: Setting, *, size: float) -> Telegraph:
    """Draw jumps of 0.1 to 1.5 V that last 0.2 to 2 s."""
    return Telegraph(float(rng.choice([-1.0, 1.0])) * between(0.1, 1.5, size=size), float(0.2 * 10.0 ** rng.random()))
