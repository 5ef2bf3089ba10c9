"""An acceleration sensor on any shaft or part in a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.point_sensor import PointSensor


@dataclass(frozen=True, kw_only=True)
class AccelerationSensor(PointSensor):
    """The acceleration [rad/s^2], in a line [m/s^2], of the part ``at``."""

    kind: Literal["acceleration_sensor"] = "acceleration_sensor"
    noise_rms: Annotated[float, Parameter("rad/s^2", "rms of the noise", low=0)] = 0.0
    zero: Annotated[float, Parameter("rad/s^2", "reading at rest")] = 0.0
    zero_tolerance: Annotated[float, Parameter("rad/s^2", "largest error of the zero", low=0)] | None = None
