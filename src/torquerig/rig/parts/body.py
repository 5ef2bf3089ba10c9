"""A turning body: the wear part, a flywheel, a pulley; inertia and friction on one shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.bearing import Smoothing, bearing_friction
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Body(Part):
    """Inertia with friction against the frame: ``torque = viscous w + coulomb tanh(w / smoothing)``."""

    on_shaft: ClassVar[bool] = True

    kind: Literal["body"] = "body"
    inertia: Annotated[float, Parameter("kg*m^2", "inertia", above=0)]
    viscous: Annotated[float, Parameter("N*m*s/rad", "viscous friction", low=0)] = 0.0
    coulomb: Annotated[float, Parameter("N*m", "Coulomb friction", low=0)] = 0.0
    smoothing: Smoothing = 0.02

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return inertia and friction."""
        node = rig.node(self.name)
        friction = bearing_friction(
            self.name, node, viscous=self.viscous, coulomb=self.coulomb, smoothing=self.smoothing
        )
        return Inertia(node=node, inertia=self.inertia), *friction
