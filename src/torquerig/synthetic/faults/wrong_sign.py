"""A torque sensor that is connected the wrong way round."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Acts, Choice, Disturbed, DrawnFault


@dataclass(frozen=True, kw_only=True)
class WrongSign(DrawnFault):
    """The reading has the other sign."""

    type: Literal["wrong_sign"] = "wrong_sign"
    sign: Annotated[Literal[-1, 1], Choice("of the reading: -1 for the other sign, 1 for the right one")] = -1

    zero: ClassVar[dict[str, Any]] = {"sign": 1}
    acts_on: ClassVar[Acts] = "whole"
    unnamed: ClassVar[str] = "samples do not show their sign; diagnose compares it with a model"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the other sign."""
        name = recording.torque_name()
        return Disturbed(recording=recording.with_values(name, self.sign * recording.channels[name].values))
