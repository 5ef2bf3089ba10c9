"""Single samples that are far off: a bit error, or a discharge into the cable."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_added_torque
from torquerig.synthetic.faults.moments import drawn_moments


@dataclass(frozen=True, kw_only=True)
class Spikes(DrawnFault):
    """One sample is off by ``height``, up or down."""

    type: Literal["spikes"] = "spikes"
    height: Annotated[float, Parameter("N*m", "size of each", low=0)] = 0.5
    rate: Annotated[float, Parameter("1/s", "number", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"height": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = r"has \d+ spike"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with spikes, and their samples."""
        starts = drawn_moments(recording, self.rate, rng, fault=self.type)
        added = np.zeros(recording.samples)
        added[starts] = self.height * rng.choice([-1.0, 1.0], starts.size)
        return Disturbed(recording=with_added_torque(recording, added), affected=added != 0)
