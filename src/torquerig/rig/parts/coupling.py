"""A shaft coupling or a length of shaft: a spring and damper, ratio 1."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.bearing import Coulomb, Smoothing, Viscous, bearing_friction
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Coupling(Part):
    """A bellows, jaw or plain shaft; its inertia, if stated, is on its output side."""

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["coupling"] = "coupling"
    stiffness: Annotated[float, Parameter("N*m/rad", "torsional stiffness", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "torsional damping", low=0)]
    inertia: Annotated[float, Parameter("kg*m^2", "inertia of the output side", low=0)] = 0.0
    rest_angle: Annotated[float, Parameter("rad", "input angle less output angle without torque")] = 0.0
    viscous: Viscous = 0.0
    coulomb: Coulomb = 0.0
    smoothing: Smoothing = 0.02

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, with the errors that effects add, and inertia and friction of the output side."""
        spring = stage_spring(rig, self.name, stiffness=self.stiffness, damping=self.damping, rest=self.rest_angle)
        friction = bearing_friction(
            self.name, spring.b, viscous=self.viscous, coulomb=self.coulomb, smoothing=self.smoothing
        )
        return Inertia(node=spring.b, inertia=self.inertia), spring, *friction
