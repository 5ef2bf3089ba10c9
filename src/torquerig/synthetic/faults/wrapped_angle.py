"""An angle that starts again after a turn, or a counter that overflows."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.synthetic.faults.drawn_fault import Choice, Disturbed, DrawnFault, Whole
from torquerig.synthetic.faults.measured import angle_name, counts_name
from torquerig.units import UNITS


@dataclass(frozen=True, kw_only=True)
class WrappedAngle(DrawnFault):
    """The angle is written in ``unit`` and starts again after one turn; counts start again at two to the ``bits``."""

    type: Literal["wrapped_angle"] = "wrapped_angle"
    unit: Annotated[Literal["deg", "rad", "rev", "count"], Choice("of the angle in the file")] = "deg"
    bits: Annotated[int, Whole("of the counter, for counts; 0: it does not overflow", high=64)] = 16

    zero: ClassVar[dict[str, Any]] = {"unit": "count", "bits": 0}
    named_by: ClassVar[tuple[str, ...]] = ("info", "filter", "ordermap")
    named_as: ClassVar[str] = "which wraps at"

    def disturbed(self, recording: Recording, rng: np.random.Generator) -> Disturbed:
        """Return the recording with the wrapped angle, and the samples after the first overflow."""
        if self.unit == "count":
            name = counts_name(recording, fault=self.type)
            values = recording.channels[name].values
            wrapped = np.mod(values, 2.0**self.bits) if self.bits else values
            return Disturbed(recording=recording.with_values(name, wrapped), affected=wrapped != values)
        name = angle_name(recording, fault=self.type)
        channel = recording.channels[name]
        unit = UNITS["angle"][self.unit]
        angle = channel.in_si() / unit
        wrapped = np.mod(angle, 2 * np.pi / unit)
        written = replace(channel, values=wrapped, unit=self.unit, si_per_unit=unit)
        channels = {
            f"{channel.quantity}_{self.unit}" if each == name else each: written if each == name else one
            for each, one in recording.channels.items()
        }
        return Disturbed(recording=replace(recording, channels=channels), affected=wrapped != angle)
