"""Times that are rounded: whole milliseconds at 2.5 kHz."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.parameter import Parameter
from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Disturbed, DrawnFault
from torquerig.synthetic.faults.measured import STAMPS, with_stamps


@dataclass(frozen=True, kw_only=True)
class CoarseStamps(DrawnFault):
    """Each time is rounded down to a whole multiple of ``grain``."""

    type: Literal["coarse_stamps"] = "coarse_stamps"
    grain: Annotated[float, Parameter("s", "distance of two times that can be written; 0 s: exact", low=0)] = 1e-3

    zero: ClassVar[dict[str, Any]] = {"grain": 0.0}
    acts_on: ClassVar[Acts] = "whole"
    named_by: ClassVar[tuple[str, ...]] = ("info",)
    named_as: ClassVar[str] = "are in steps of"
    needs_times: ClassVar[bool] = True

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with coarse times."""
        stamped = with_stamps(recording)
        if self.grain == 0:
            return Disturbed(recording=stamped)
        times = stamped.channels[STAMPS].values
        # a time on the grid stays there whatever its rounding error
        grains = np.floor(times / self.grain + 1e-6)
        return Disturbed(recording=stamped.with_values(STAMPS, np.round(grains * self.grain, 12)))
