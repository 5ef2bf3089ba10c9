"""A sidecar that states another scale than the sensor has."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.units import UNITS


@dataclass(frozen=True, kw_only=True)
class WrongScale(DrawnFault):
    """The stated scale is the true one times ``factor``; the samples are the same."""

    type: Literal["wrong_scale"] = "wrong_scale"
    factor: Annotated[float, Parameter("1", "stated scale as a multiple of the true one", above=0)] = 10.0

    zero: ClassVar[dict[str, Any]] = {"factor": 1.0}
    acts_on: ClassVar[Acts] = "whole"
    unnamed: ClassVar[str] = "samples do not show their scale; diagnose compares it with a model"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the wrong scale."""
        name = recording.torque_name()
        channel = recording.channels[name]
        if self.factor == 1:
            return Disturbed(recording=recording)
        if channel.unit in UNITS["torque"] or channel.unit in UNITS["force"]:
            # a torque in N*m has no scale to state: its numbers are wrong
            return Disturbed(recording=recording.with_values(name, self.factor * channel.values))
        wrong = replace(channel, si_per_unit=self.factor * channel.si_per_unit)
        return Disturbed(recording=recording.with_channel(name, wrong))
