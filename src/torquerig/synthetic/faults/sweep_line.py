"""A line whose frequency sweeps while the speed is steady: another drive that runs up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import with_added_torque
from torquerig.synthetic.sweep import sweep


@dataclass(frozen=True, kw_only=True)
class SweepLine(DrawnFault):
    """A sine from ``start`` to ``stop`` over the whole recording, linear in time."""

    type: Literal["sweep"] = "sweep"
    amplitude: Annotated[float, Parameter("N*m", "zero to peak", low=0)] = 0.02
    start: Annotated[float, Parameter("Hz", "frequency at the first sample", above=0)] = 300.0
    stop: Annotated[float, Parameter("Hz", "frequency at the end", above=0)] = 660.0

    zero: ClassVar[dict[str, Any]] = {"amplitude": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "a line sweeps"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the sweep."""
        highest = max(self.start, self.stop)
        if highest >= recording.sample_rate / 2:
            raise InputError(
                f"sweep: {highest:g} Hz is not below half the sample rate of {recording.sample_rate:g} Hz; lower it"
            )
        wave = sweep(recording.time(), start=self.start, stop=self.stop, duration=recording.duration, logarithmic=False)
        return Disturbed(recording=with_added_torque(recording, self.amplitude * wave))
