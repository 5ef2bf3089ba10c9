"""A torque sensor: a spring in the shaft, an amplifier, noise and a converter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import Coulomb, Smoothing, Viscous, bearing_friction
from torquerig.rig.terms import Inertia, Spring, Term


@dataclass(frozen=True, kw_only=True)
class TorqueSensor(AmplifiedTorqueSensor):
    """The torque in the shaft between the part before it and its output side, through the measuring chain."""

    on_shaft: ClassVar[bool] = True

    kind: Literal["torque_sensor"] = "torque_sensor"
    inertia: Annotated[float, Parameter("kg*m^2", "inertia of the output side", low=0)]
    viscous: Viscous = 0.0
    coulomb: Coulomb = 0.0
    smoothing: Smoothing = 0.02

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, and inertia and friction of its output side."""
        upstream, node = rig.upstream(self.name), rig.node(self.name)
        spring = Spring(name=self.name, a=upstream, b=node, stiffness=self.stiffness, damping=self.damping)
        friction = bearing_friction(
            self.name, node, viscous=self.viscous, coulomb=self.coulomb, smoothing=self.smoothing
        )
        return Inertia(node=node, inertia=self.inertia), spring, *friction
