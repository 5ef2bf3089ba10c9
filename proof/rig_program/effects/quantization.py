"""Quantization: the file has coarser steps than the converter."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from proof.rig_program.effects.effect import Effect, Setting, between
from proof.rig_program.plan import Run
from proof.rig_program.recorded import Recording


@dataclass(frozen=True)
class Quantization(Effect):
    """V = step * round(V / step) [V]."""

    kind: ClassVar[str] = "quantization"
    step: float

    def parameters(self) -> dict[str, float | None]:
        """Return the step."""
        return {"step_V": self.step}

    def on_file(self, recording: Recording, run: Run, rng: np.random.Generator) -> Recording:
        """Round what the converter gave."""
        return replace(recording, torque=self.step * np.round(recording.torque / self.step))


def draw_quantization(rng: np.random.Generator, setting: Setting, *, size: float) -> Quantization:
    """Draw a step of 2 mV to 0.4 V."""
    return Quantization(between(0.002, 0.4, size=size))
