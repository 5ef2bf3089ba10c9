"""In no library: the recorder loses samples or writes some twice, and its clock jumps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from proof.rig_program import nominal
from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run
from proof.rig_program.recorded import Recording


@dataclass(frozen=True)
class TimeBaseJump(Effect):
    """Stretches of this length [s] are written twice, or lost and made up for, so often in a run."""

    kind: ClassVar[str] = "time_base_jump"
    in_library: ClassVar[bool] = False
    length: float
    count: int

    def parameters(self) -> dict[str, float | None]:
        """Length and number."""
        return {"length_s": self.length, "per_run": float(self.count)}

    def on_file(self, recording: Recording, run: Run, rng: np.random.Generator) -> Recording:
        """Take samples from where the clock says; the number of samples stays."""
        size = recording.torque.size
        jump = round(self.length * nominal.SAMPLE_RATE)
        source = np.arange(size)
        ahead = 0
        for start in np.sort(rng.integers(size // 20, size - size // 20, self.count)):
            step = -jump if ahead > 0 else jump
            ahead += step
            source[start:] += step
        source = np.clip(source, 0, size - 1)
        return Recording(recording.torque[source], recording.encoder[source])


def draw_time_base_jump(rng: np.random.Generator, setting: Setting, *, size: float) -> TimeBaseJump:
    """Draw 4 to 12 jumps of 8 to 120 ms."""
    return TimeBaseJump(between(0.008, 0.12, size=size), 2 * int(rng.integers(2, 7)))
