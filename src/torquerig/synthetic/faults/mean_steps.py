"""A zero that steps and stays: a sensor that was hit, or a clamp that slipped."""

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
class MeanSteps(DrawnFault):
    """Each step moves the zero by ``height`` for the rest of the recording."""

    type: Literal["mean_steps"] = "mean_steps"
    height: Annotated[float, Parameter("N*m", "of each step; either sign")] = 0.6
    rate: Annotated[float, Parameter("1/s", "number of steps", low=0)] = 5 / 60

    zero: ClassVar[dict[str, Any]] = {"height": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "the mean steps"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the steps, and all samples from the first step on."""
        steps = np.zeros(recording.samples)
        steps[drawn_moments(recording, self.rate, rng, fault=self.type)] = self.height
        added = np.cumsum(steps)
        return Disturbed(recording=with_added_torque(recording, added), affected=added != 0)
