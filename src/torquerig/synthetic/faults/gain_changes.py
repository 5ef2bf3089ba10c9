"""Moments in which the whole signal is larger by one factor: an amplifier that changes its range."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.moments import drawn_moments, in_samples, within


@dataclass(frozen=True, kw_only=True)
class GainChanges(DrawnFault):
    """The reading is multiplied by ``factor`` for ``length``."""

    type: Literal["gain_changes"] = "gain_changes"
    factor: Annotated[float, Parameter("1", "of the reading within the moment", above=0)] = 1.7
    length: Annotated[float, Parameter("s", "length of each moment", above=0)] = 0.6
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 5 / 60

    zero: ClassVar[dict[str, Any]] = {"factor": 1.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "a gain which changes"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the moments, and where they are."""
        length = in_samples(self.length, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=length, fault=self.type)
        other = within(recording.samples, starts, length) & (self.factor != 1)
        name = recording.torque_name()
        values = recording.channels[name].values
        return Disturbed(
            recording=recording.with_values(name, np.where(other, self.factor * values, values)), affected=other
        )
