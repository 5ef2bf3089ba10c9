"""A shaft coupling or a length of shaft: a spring and damper, ratio 1."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.first_mode import first_elastic_mode
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Coupling(BearingPart):
    """A bellows, jaw or plain shaft; its inertia, if stated, is on its output side.

    Its damping is stated, or follows from ``loss_factor``, the energy lost per cycle over 2 pi times the energy stored:
    ``c = loss_factor k / omega``. A viscous damper has this loss at one frequency only, here that of the rig's first
    elastic mode. A damping ratio zeta of the coupling is a loss factor of 2 zeta (Nashif, Jones & Henderson, Vibration
    Damping, 1985, section 2.4).
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["coupling"] = "coupling"
    stiffness: Annotated[float, Parameter("N*m/rad", "torsional stiffness", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "torsional damping", low=0)] | None = None
    loss_factor: Annotated[float, Parameter("1", "loss factor, in place of damping", low=0)] | None = None
    inertia: Annotated[float, Parameter("kg*m^2", "inertia of the output side", low=0)] = 0.0
    rest_angle: Annotated[float, Parameter("rad", "input angle less output angle without torque")] = 0.0

    def __post_init__(self) -> None:
        if (self.damping is None) == (self.loss_factor is None):
            which = "neither damping nor loss_factor is" if self.damping is None else "both damping and loss_factor are"
            raise InputError(f"{self.name}: {which} stated; state one, such as damping: 0.02 N*m*s/rad")

    def damped(self, rig: Rig) -> float:
        """Return the torsional damping in this rig [N m s/rad]."""
        if self.damping is not None:
            return self.damping
        shafts = (part for part in rig.parts if part.on_shaft)
        terms = [
            term for part in shafts for term in (_bare(part, rig) if isinstance(part, Coupling) else part.terms(rig))
        ]
        return (self.loss_factor or 0.0) * self.stiffness / first_elastic_mode(terms)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, with the errors that effects add, and inertia and friction of the output side."""
        spring = stage_spring(rig, self.name, stiffness=self.stiffness, damping=self.damped(rig), rest=self.rest_angle)
        return Inertia(node=spring.b, inertia=self.inertia), spring, *self.friction_on(spring.b)


def _bare(coupling: Coupling, rig: Rig) -> tuple[Term, ...]:
    """Return its inertia and its spring without damping."""
    spring = stage_spring(rig, coupling.name, stiffness=coupling.stiffness, damping=0.0)
    return Inertia(node=spring.b, inertia=coupling.inertia), spring
