"""An encoder whose counts per turn differ from the sidecar: edges counted once, twice or four times."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import counts_name


@dataclass(frozen=True, kw_only=True)
class WrongCountsPerTurn(DrawnFault):
    """The encoder gives ``factor`` times the counts per turn that the sidecar states; the samples are the same."""

    type: Literal["wrong_counts_per_turn"] = "wrong_counts_per_turn"
    factor: Annotated[float, Parameter("1", "counts of a turn as a multiple of the stated ones", above=0)] = 4.0

    zero: ClassVar[dict[str, Any]] = {"factor": 1.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = r"times the set-point of \d+ rpm: \d+ counts per turn\?"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the wrong scale of its angle."""
        name = counts_name(recording, fault=self.type)
        channel = recording.channels[name]
        if self.factor == 1:
            return Disturbed(recording=recording)
        wrong = replace(channel, si_per_unit=self.factor * channel.si_per_unit)
        return Disturbed(recording=recording.with_channel(name, wrong))
