"""A sidecar that states another sample rate than the logger had."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_stamps


@dataclass(frozen=True, kw_only=True)
class WrongRate(DrawnFault):
    """The stated rate is the true one times ``factor``; a file with times has the true ones."""

    type: Literal["wrong_rate"] = "wrong_rate"
    factor: Annotated[float, Parameter("1", "stated rate as a multiple of the true one", above=0)] = 2.0

    zero: ClassVar[dict[str, Any]] = {"factor": 1.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "samples per second"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the wrong rate."""
        if self.factor == 1:
            return Disturbed(recording=recording)
        stamped = with_stamps(recording)
        return Disturbed(recording=replace(stamped, sample_rate=self.factor * recording.sample_rate))
