"""Rows that a logger wrote twice, with their times."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault, Whole
from torquerig.synthetic.faults.measured import rows, with_stamps
from torquerig.synthetic.faults.moments import drawn_moments


@dataclass(frozen=True, kw_only=True)
class DuplicateSamples(DrawnFault):
    """At each moment ``length`` rows are written twice; the mark shows the second copies."""

    type: Literal["duplicate_samples"] = "duplicate_samples"
    length: Annotated[int, Whole("rows of each moment")] = 1
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"length": 0}
    acts_on: ClassVar[Acts] = "rows"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "jumps by|too close|does not rise"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the doubled rows, and their second copies."""
        starts = drawn_moments(recording, self.rate, rng, length=max(self.length, 1), fault=self.type)
        numbers = np.arange(recording.samples)
        copies = (starts[:, None] + np.arange(self.length)).ravel()
        places = np.repeat(starts + self.length, self.length)
        second = np.insert(np.zeros(recording.samples, dtype=bool), places, values=True)
        return Disturbed(recording=rows(with_stamps(recording), np.insert(numbers, places, copies)), affected=second)
