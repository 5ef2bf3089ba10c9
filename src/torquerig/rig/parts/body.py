"""A turning body: the wear part, a flywheel, a pulley; inertia and friction on one shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Friction, Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Body(Part):
    """Inertia with viscous friction against the frame: ``torque = viscous w``."""

    on_shaft: ClassVar[bool] = True

    kind: Literal["body"] = "body"
    inertia: Annotated[float, Parameter("kg*m^2", "inertia", above=0)]
    viscous: Annotated[float, Parameter("N*m*s/rad", "viscous friction", low=0)] = 0.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return inertia and viscous friction."""
        node = rig.node(self.name)
        drag = Friction(name=f"{self.name}.viscous", on=node, viscous=self.viscous)
        return Inertia(node=node, inertia=self.inertia), drag
