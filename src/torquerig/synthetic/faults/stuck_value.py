"""Moments in which the reading keeps one value: a converter or a bus that hangs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.moments import drawn_moments, in_samples, within


@dataclass(frozen=True, kw_only=True)
class StuckValue(DrawnFault):
    """The reading keeps the value of the sample before for ``length``."""

    type: Literal["stuck_value"] = "stuck_value"
    length: Annotated[float, Parameter("s", "length of each moment", low=0)] = 0.1
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 10 / 60

    zero: ClassVar[dict[str, Any]] = {"length": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "holds one value"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with stuck values, and where they are."""
        length = in_samples(self.length, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=max(length, 1), fault=self.type)
        stuck = within(recording.samples, starts, length)
        name = recording.torque_name()
        source = np.maximum.accumulate(np.where(stuck, 0, np.arange(recording.samples)))
        return Disturbed(recording=recording.with_values(name, recording.channels[name].values[source]), affected=stuck)
