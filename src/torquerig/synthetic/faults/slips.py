"""A clutch or coupling that lets go under load and grips again, and swings the shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_added_torque
from torquerig.synthetic.faults.moments import drawn_moments, in_samples, within


@dataclass(frozen=True, kw_only=True)
class Slips(DrawnFault):
    """Each blow is a decaying swing to both sides; the mark ends after five time constants."""

    type: Literal["slips"] = "slips"
    height: Annotated[float, Parameter("N*m", "of the swing at its begin", low=0)] = 4.0
    frequency: Annotated[float, Parameter("Hz", "of the swing", above=0)] = 60.0
    decay: Annotated[float, Parameter("s", "time constant", above=0)] = 25e-3
    rate: Annotated[float, Parameter("1/s", "number of blows", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"height": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "what slips and grips"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the blows, and where they swing."""
        length = in_samples(5 * self.decay, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=length, fault=self.type)
        since = np.arange(length) / recording.sample_rate
        swing = self.height * np.exp(-since / self.decay) * np.sin(2 * np.pi * self.frequency * since)
        added = np.zeros(recording.samples)
        for start in starts.tolist():
            added[start : start + length] = swing
        affected = within(recording.samples, starts, length) & (self.height != 0)
        return Disturbed(recording=with_added_torque(recording, added), affected=affected)
