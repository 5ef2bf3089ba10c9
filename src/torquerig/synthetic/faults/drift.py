"""A zero that drifts while sensor and amplifier warm up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_added_torque


@dataclass(frozen=True, kw_only=True)
class Drift(DrawnFault):
    """The zero moves by ``span``: exponentially with ``time_constant``, or along a straight line."""

    type: Literal["drift"] = "drift"
    span: Annotated[float, Parameter("N*m", "change of the zero; either sign")] = 0.2
    time_constant: Annotated[float, Parameter("s", "of the exponential; 0 s: a straight line", low=0)] = 0.0

    zero: ClassVar[dict[str, Any]] = {"span": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    unnamed: ClassVar[str] = "a slow change may be the load's; diagnose compares it with a model"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the drift."""
        if self.time_constant:
            course = -np.expm1(-recording.time() / self.time_constant)
        else:
            course = recording.time() / recording.duration
        return Disturbed(recording=with_added_torque(recording, self.span * course))
