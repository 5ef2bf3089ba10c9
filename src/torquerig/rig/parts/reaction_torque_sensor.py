"""A reaction torque sensor at the foot of a motor: it holds the housing, and reads what the housing is turned by."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.motor import Motor
from torquerig.rig.terms import GROUND, Inertia, Spring, Term


@dataclass(frozen=True, kw_only=True)
class ReactionTorqueSensor(AmplifiedTorqueSensor):
    """``T = -(k theta_h + c theta_h')`` between the frame and the housing h; ``J_h theta_h'' = T - T_e + T_f``.

    ``T_e`` is all torque between the coils and the rotor (the drive's torque with its ripple, cogging), ``T_f`` the
    friction of the motor on its rotor. So a stiff sensor reads ``T_e - T_f``: the torques that the shaft takes from
    the rotor plus ``J dw/dt`` of the rotor, positive where the motor drives forwards. Friction of the motor cancels.
    Loads, an imbalance and a drag of air at the motor act from outside and are not read, nor is a ``replayed_torque``.

    Source: Newton's third law for the housing; the trunnion-mounted (cradle) dynamometer. Not true where cables or
    hoses hold the housing, or where a bearing of the cradle has friction.
    """

    kind: Literal["reaction_torque_sensor"] = "reaction_torque_sensor"
    motor: str = "motor"
    housing_inertia: Annotated[float, Parameter("kg*m^2", "inertia of what it holds, without the rotor", above=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the housing and the spring that holds it; InputError where ``motor`` is no motor, or held twice."""
        if not isinstance(rig.part(self.motor), Motor):
            raise InputError(f"{self.name}: motor: {self.motor!r} is no motor; name one")
        held = [part.name for part in rig.parts_of(ReactionTorqueSensor) if part.motor == self.motor]
        if len(held) > 1:
            raise InputError(f"{held[1]}: {held[0]} holds the housing of {self.motor!r} already; leave one out")
        spring = Spring(name=self.name, a=GROUND, b=self.name, stiffness=self.stiffness, damping=self.damping)
        return Inertia(node=self.name, inertia=self.housing_inertia), spring
