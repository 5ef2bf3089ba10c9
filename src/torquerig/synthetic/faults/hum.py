"""Interference of the mains."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault, Whole
from torquerig.synthetic.faults.measured import with_added_torque


@dataclass(frozen=True, kw_only=True)
class Hum(DrawnFault):
    """Lines at the mains frequency and its harmonics; harmonic h has the amplitude divided by h, and a drawn phase."""

    type: Literal["hum"] = "hum"
    amplitude: Annotated[float, Parameter("N*m", "of the mains frequency, zero to peak", low=0)] = 0.02
    frequency: Annotated[float, Parameter("Hz", "of the mains", above=0)] = 50.0
    harmonics: Annotated[int, Whole("number of lines, the mains frequency included", low=1, high=1000)] = 3

    zero: ClassVar[dict[str, Any]] = {"amplitude": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("ordermap",)
    named_as: ClassVar[str] = r"\b1 x mains"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with hum."""
        numbers = np.arange(1, self.harmonics + 1)
        phases = rng.uniform(0, 2 * np.pi, self.harmonics)
        turns = 2 * np.pi * self.frequency * recording.time()
        added = np.zeros(recording.samples)
        for harmonic, phase in zip(numbers.tolist(), phases.tolist(), strict=True):
            added += self.amplitude / harmonic * np.cos(harmonic * turns + phase)
        return Disturbed(recording=with_added_torque(recording, added))
