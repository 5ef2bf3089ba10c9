"""Times that a computer's clock gives to samples when they arrive, not when they were taken."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import STAMPS, with_stamps
from torquerig.synthetic.faults.moments import drawn_moments


@dataclass(frozen=True, kw_only=True)
class LateStamps(DrawnFault):
    """Each time is late by a random amount, and after a pause of the computer several rows arrive at once.

    The samples are taken evenly. The mark shows rows that are late by more than one sample.
    """

    type: Literal["late_stamps"] = "late_stamps"
    lateness: Annotated[float, Parameter("s", "mean lateness of a row; exponentially distributed", low=0)] = 40e-6
    pause: Annotated[float, Parameter("s", "length of a pause of the computer", low=0)] = 2e-3
    rate: Annotated[float, Parameter("1/s", "number of pauses", low=0)] = 20 / 60

    zero: ClassVar[dict[str, Any]] = {"lateness": 0.0, "pause": 0.0}
    acts_on: ClassVar[Acts] = "stamps"
    named_by: ClassVar[tuple[str, ...]] = ("info",)
    named_as: ClassVar[str] = "back to an even|off an even"
    needs_times: ClassVar[bool] = True

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with late times, and the rows that are late by more than one sample."""
        stamped = with_stamps(recording)
        times = stamped.channels[STAMPS].values
        late = times + rng.exponential(1.0, times.size) * self.lateness
        for start in drawn_moments(recording, self.rate, rng, fault=self.type).tolist():
            rows = slice(start, int(np.searchsorted(times, times[start] + self.pause)))
            late[rows] = np.maximum(late[rows], times[start] + self.pause)
        # the computer writes its rows in order
        late = np.maximum.accumulate(late)
        affected = late - times > 1 / recording.sample_rate
        return Disturbed(recording=stamped.with_values(STAMPS, late), affected=affected)
