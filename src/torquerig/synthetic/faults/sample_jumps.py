"""A zero that jumps from one sample to the next by amounts that differ: a sliding contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_added_torque
from torquerig.synthetic.faults.moments import drawn_moments, in_samples


@dataclass(frozen=True, kw_only=True)
class SampleJumps(DrawnFault):
    """In each moment the zero jumps four times, by up to ``height`` up or down, and is then back."""

    type: Literal["sample_jumps"] = "sample_jumps"
    height: Annotated[float, Parameter("N*m", "largest distance from the true zero", low=0)] = 0.5
    length: Annotated[float, Parameter("s", "length of each moment", above=0)] = 70e-3
    rate: Annotated[float, Parameter("1/s", "number of moments", low=0)] = 10 / 60

    zero: ClassVar[dict[str, Any]] = {"height": 0.0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "jumps"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the jumps, and where its zero is off."""
        length = in_samples(self.length, recording, fault=self.type)
        starts = drawn_moments(recording, self.rate, rng, length=length, fault=self.type)
        added = np.zeros(recording.samples)
        for start in starts.tolist():
            levels = self.height * rng.uniform(0.6, 1.0, 3) * np.array([1.0, -1.0, 1.0]) * rng.choice([-1.0, 1.0])
            ends = start + np.linspace(0, length, 4).astype(int)
            for level, first, last in zip(levels.tolist(), ends[:-1].tolist(), ends[1:].tolist(), strict=True):
                added[first:last] = level
        return Disturbed(recording=with_added_torque(recording, added), affected=added != 0)
