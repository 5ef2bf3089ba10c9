"""A torque sensor: a spring in the shaft, an amplifier, noise and a converter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.terms import Inertia, Spring, Term


@dataclass(frozen=True, kw_only=True)
class TorqueSensor(AmplifiedTorqueSensor, BearingPart):
    """The torque in the shaft between the part before it and its output side, through the measuring chain."""

    on_shaft: ClassVar[bool] = True

    kind: Literal["torque_sensor"] = "torque_sensor"
    inertia: Annotated[float, Parameter("kg*m^2", "inertia of the output side", low=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, and inertia and friction of its output side."""
        upstream, node = rig.upstream(self.name), rig.node(self.name)
        spring = Spring(name=self.name, a=upstream, b=node, stiffness=self.stiffness, damping=self.damping)
        return Inertia(node=node, inertia=self.inertia), spring, *self.friction_on(node)
