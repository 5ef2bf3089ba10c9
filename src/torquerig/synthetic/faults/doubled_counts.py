"""Counts of an encoder that are counted twice: an edge that bounces, or interference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.counter_steps import with_counter_steps
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault, Whole


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
        return with_counter_steps(recording, rng, counts=self.counts, rate=self.rate, fault=self.type)
