"""A torque that is renewed more seldom than it is written: a telemetry, or a slow bus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault, Whole


@dataclass(frozen=True, kw_only=True)
class HeldSamples(DrawnFault):
    """Each value is held for ``every`` samples."""

    type: Literal["held_samples"] = "held_samples"
    every: Annotated[int, Whole("samples from one renewal to the next; 1: none is held", low=1)] = 4

    zero: ClassVar[dict[str, Any]] = {"every": 1}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "renewed only every"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with held samples, and those that are not renewed."""
        numbers = np.arange(recording.samples)
        name = recording.torque_name()
        values = recording.channels[name].values[numbers // self.every * self.every]
        return Disturbed(recording=recording.with_values(name, values), affected=numbers % self.every != 0)
