"""A sampled PI speed controller that drives a motor."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.part import Part
from torquerig.rig.parts.motor import Motor
from torquerig.rig.rig import Rig
from torquerig.rig.terms import Drive, Term


@dataclass(frozen=True, kw_only=True)
class SpeedController(Part):
    """PI on the motor speed, once a sample; the integrator holds while the torque limit of the motor is reached.

    Ripple in proportion to the motor torque (commutation, current gain) is collected from the effects of the rig.
    """

    kind: Literal["speed_controller"] = "speed_controller"
    motor: str = "motor"
    kp: Annotated[float, Parameter("N*m*s/rad", "proportional gain", above=0)]
    ki: Annotated[float, Parameter("N*m/rad", "integral gain", low=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the drive of the motor."""
        motor = rig.part(self.motor)
        if not isinstance(motor, Motor):
            raise InputError(f"{self.name}: motor: {self.motor!r} is no motor; name one")
        ripple = tuple(wave for part in rig.parts for wave in part.drive_ripple(self.motor, rig))
        return (
            Drive(
                name=self.name,
                on=rig.node(self.motor),
                kp=self.kp,
                ki=self.ki,
                torque_limit=motor.torque_limit,
                lag=1 / (2 * pi * motor.current_loop_bandwidth),
                ripple=ripple,
            ),
        )
