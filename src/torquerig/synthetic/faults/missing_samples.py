"""Rows that a logger did not write; their times are missing too."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault, Whole
from torquerig.synthetic.faults.measured import rows, with_stamps
from torquerig.synthetic.faults.moments import drawn_moments, within


@dataclass(frozen=True, kw_only=True)
class MissingSamples(DrawnFault):
    """At each moment ``length`` rows are missing; the mark shows the row after them."""

    type: Literal["missing_samples"] = "missing_samples"
    length: Annotated[int, Whole("rows of each moment")] = 1
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"length": 0}
    acts_on: ClassVar[Acts] = "rows"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "jumps by|lost in"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording without the rows, and the row after each gap."""
        starts = drawn_moments(recording, self.rate, rng, length=max(self.length, 1), fault=self.type)
        lost = within(recording.samples, starts, self.length)
        after = np.zeros(recording.samples, dtype=bool)
        after[starts + self.length] = self.length > 0
        kept = np.flatnonzero(~lost)
        return Disturbed(recording=rows(with_stamps(recording), kept), affected=after[kept])
