"""How a simulated rig is recorded: sample rate, length and settling time."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict

from torquerig.parameter import Parameter
from torquerig.simulation.sampling import SAMPLE_RATE, SETTLING

DURATION = 10.0  # [s] of a recording where nothing states another length


class RecordingSettings(BaseModel):
    """The section ``recording:`` of a scenario.

    The sampled speed controller runs at ``sample_rate`` too. ``duration`` counts where the profile has no length.
    ``settling`` is the time that the rig turns before the recording starts; some five times the slowest time constant
    of the speed loop are enough.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    sample_rate: Annotated[float, Parameter("Hz", "sample rate of converter and speed controller", above=0)] = (
        SAMPLE_RATE
    )
    duration: Annotated[float, Parameter("s", "length of a recording", above=0)] = DURATION
    settling: Annotated[float, Parameter("s", "time that the rig turns before the recording", low=0)] = SETTLING
