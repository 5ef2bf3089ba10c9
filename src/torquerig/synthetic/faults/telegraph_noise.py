"""A zero that jumps between two levels: a loose contact, or a popcorn-noise amplifier."""

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
class TelegraphNoise(DrawnFault):
    """The zero jumps by ``height`` and back, at random moments."""

    type: Literal["telegraph_noise"] = "telegraph_noise"
    height: Annotated[float, Parameter("N*m", "distance of the two levels; either sign")] = 0.4
    rate: Annotated[float, Parameter("1/s", "number of jumps, up and down", low=0)] = 40 / 60

    zero: ClassVar[dict[str, Any]] = {"height": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "two levels"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the jumps, and where it is at the other level."""
        jumps = np.zeros(recording.samples, dtype=np.int_)
        jumps[drawn_moments(recording, self.rate, rng, fault=self.type)] = 1
        other = (np.cumsum(jumps) % 2 == 1) & (self.height != 0)
        return Disturbed(recording=with_added_torque(recording, self.height * other), affected=other)
