"""A sampled PI speed controller that drives a motor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.motor_drive import motor_drive
from torquerig.rig.parts.torque_controller import TorqueController
from torquerig.rig.terms import Term


@dataclass(frozen=True, kw_only=True)
class SpeedController(Part):
    """PI on the motor speed, once a sample; the integrator holds while the torque limit of the motor is reached.

    Ripple in proportion to the motor torque (commutation, current gain) is collected from the effects of the rig. It
    sees the true speed, or that of the encoder which names it; a torque_controller beside it feeds forward.
    """

    kind: Literal["speed_controller"] = "speed_controller"
    motor: str = "motor"
    kp: Annotated[float, Parameter("N*m*s/rad", "proportional gain", above=0)]
    ki: Annotated[float, Parameter("N*m/rad", "integral gain", low=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the drive of the motor; InputError where two torque controllers feed into it."""
        fed = [part for part in rig.parts_of(TorqueController) if part.beside == self.name]
        if len(fed) > 1:
            raise InputError(f"{self.name}: {fed[0].name} and {fed[1].name} both stand beside it; leave one out")
        torque, demand = (fed[0].torque, fed[0].demand(rig)) if fed else (0.0, None)
        return (motor_drive(rig, self.name, motor=self.motor, kp=self.kp, ki=self.ki, torque=torque, demand=demand),)
