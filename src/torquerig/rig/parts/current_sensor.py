"""A current sensor in the supply of a motor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.motor_phases import MotorPhases
from torquerig.rig.point_sensor import PointSensor
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class CurrentSensor(PointSensor):
    """The current [A] that makes the motor's torque: ``torque / torque_constant``, ripple and friction not in it."""

    kind: Literal["current_sensor"] = "current_sensor"
    at: str = "motor"
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per current", above=0)] | None = None
    noise_rms: Annotated[float, Parameter("A", "rms of the noise", low=0)] = 0.0
    zero: Annotated[float, Parameter("A", "reading at rest")] = 0.0
    zero_tolerance: Annotated[float, Parameter("A", "largest error of the zero", low=0)] | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return nothing; InputError where nothing drives ``at``, or its torque constant is nowhere stated."""
        self.newton_metres_per_ampere(rig)
        return ()

    def newton_metres_per_ampere(self, rig: Rig) -> float:
        """Return the stated torque constant, else that of the motor's phases, per ampere of peak phase current."""
        rig.node(self.at)
        if self.torque_constant is not None:
            return self.torque_constant
        for part in rig.parts_of(MotorPhases):
            if part.motor == self.at:
                return part.torque_per_ampere
        raise InputError(
            f"{self.name}: a current needs the torque constant of {self.at!r}; add torque_constant:, such as "
            "0.11 N*m/A, or a part of kind motor_phases"
        )
