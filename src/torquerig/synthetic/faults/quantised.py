"""A reading on codes that are too coarse."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault


@dataclass(frozen=True, kw_only=True)
class Quantised(DrawnFault):
    """The reading is rounded to whole multiples of a step."""

    type: Literal["quantised"] = "quantised"
    step: Annotated[float, Parameter("N*m", "distance of two codes", low=0)] = 0.02

    zero: ClassVar[dict[str, Any]] = {"step": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    unnamed: ClassVar[str] = "what is too coarse depends on the converter, which a scenario states; diagnose names it"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording on coarse codes."""
        name = recording.torque_name()
        channel = recording.channels[name]
        if self.step == 0:
            return Disturbed(recording=recording)
        step = self.step / abs(channel.si_per_unit)
        return Disturbed(recording=recording.with_values(name, step * np.round(channel.values / step)))
