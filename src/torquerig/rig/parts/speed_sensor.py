"""A speed sensor on any shaft or part in a line: a tachogenerator, a rate of an encoder's counter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.point_sensor import PointSensor


@dataclass(frozen=True, kw_only=True)
class SpeedSensor(PointSensor):
    """The speed [rad/s], in a line the velocity [m/s], of the part ``at``."""

    kind: Literal["speed_sensor"] = "speed_sensor"
    noise_rms: Annotated[float, Parameter("rad/s", "rms of the noise", low=0)] = 0.0
    zero: Annotated[float, Parameter("rad/s", "reading at rest")] = 0.0
    zero_tolerance: Annotated[float, Parameter("rad/s", "largest error of the zero", low=0)] | None = None
