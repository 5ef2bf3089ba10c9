"""Counts of an encoder that are counted twice: an edge that bounces, or interference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault, Whole
from torquerig.synthetic.faults.measured import counts_name
from torquerig.synthetic.faults.moments import drawn_moments


@dataclass(frozen=True, kw_only=True)
class DoubledCounts(DrawnFault):
    """From each event on the counter is ahead by ``counts``; the mark shows the event."""

    type: Literal["doubled_counts"] = "doubled_counts"
    counts: Annotated[int, Whole("of each event")] = 200
    rate: Annotated[float, Parameter("1/s", "number of events", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"counts": 0}
    acts_on: ClassVar[Acts] = "steps"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "jumps"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the wrong counts, and the sample after each event."""
        name = counts_name(recording, fault=self.type)
        values = recording.channels[name].values
        turns = 1.0 if values[-1] >= values[0] else -1.0
        off = np.zeros(recording.samples)
        off[drawn_moments(recording, self.rate, rng, fault=self.type)] = turns * self.counts
        return Disturbed(recording=recording.with_values(name, values + np.cumsum(off)), affected=off != 0)
