"""Stretches that repeat the one before: a logger whose buffer was read again."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import measured_names, rows
from torquerig.synthetic.faults.moments import drawn_moments, in_samples, within


@dataclass(frozen=True, kw_only=True)
class RepeatedSamples(DrawnFault):
    """In place of a buffer of all channels, the buffer before is written once more."""

    type: Literal["repeated_samples"] = "repeated_samples"
    length: Annotated[float, Parameter("s", "length of the buffer", low=0)] = 40e-3
    rate: Annotated[float, Parameter("1/s", "number of buffers", low=0)] = 10 / 60

    zero: ClassVar[dict[str, Any]] = {"length": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "samples repeat earlier ones"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with repeated buffers, and the samples of each second copy."""
        length = in_samples(self.length, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=max(2 * length, 1), fault=self.type)
        second = within(recording.samples, starts + length, length)
        numbers = np.arange(recording.samples) - length * second
        return Disturbed(recording=rows(recording, numbers, measured_names(recording)), affected=second)
