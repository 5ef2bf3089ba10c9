"""A turning body: the wear part, a flywheel, a pulley; inertia and friction on one shaft."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Body(BearingPart):
    """Inertia with friction against the frame: ``torque = viscous w + coulomb tanh(w / smoothing)``."""

    on_shaft: ClassVar[bool] = True

    kind: Literal["body"] = "body"
    inertia: Annotated[float, Parameter("kg*m^2", "inertia", above=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return inertia and friction."""
        node = rig.node(self.name)
        return Inertia(node=node, inertia=self.inertia), *self.friction_on(node)
