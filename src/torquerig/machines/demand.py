"""The demand on a drive: a torque, or a speed held by a sampled PI controller."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from torquerig.machines import kernel
from torquerig.machines.checks import check_fields
from torquerig.parameter import Parameter


@dataclass(frozen=True, kw_only=True)
class TorqueDemand:
    """A constant torque [N*m], converted to a current by the machine's torque constant, without feedback."""

    torque: Annotated[float, Parameter("N*m", "torque demand")]

    def __post_init__(self) -> None:
        check_fields(self)

    def kernel_row(self, torque_per_ampere: float) -> kernel.Demand:
        """Return the demand as a current."""
        current = self.torque / torque_per_ampere
        return kernel.Demand(current, 0.0, 0.0, 0.0, abs(current))


@dataclass(frozen=True, kw_only=True)
class SpeedDemand:
    """A speed [rad/s] held by PI, sampled with the current loop; the integrator stops where the limit is reached."""

    speed: Annotated[float, Parameter("rad/s", "speed demand")]
    proportional: Annotated[float, Parameter("N*m*s/rad", "proportional gain", low=0)]
    integral: Annotated[float, Parameter("N*m/rad", "integral gain", low=0)]
    torque_limit: Annotated[float, Parameter("N*m", "limit of the torque demand", above=0)]

    def __post_init__(self) -> None:
        check_fields(self)

    def kernel_row(self, torque_per_ampere: float) -> kernel.Demand:
        """Return the loop with gains in amperes."""
        gains = self.proportional / torque_per_ampere, self.integral / torque_per_ampere
        return kernel.Demand(0.0, *gains, self.speed, self.torque_limit / torque_per_ampere)


Demand = TorqueDemand | SpeedDemand
