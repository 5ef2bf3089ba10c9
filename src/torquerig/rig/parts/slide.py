"""A mass that moves in a line: a carriage, a piston, a table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import GuidedPart
from torquerig.rig.terms import Friction, Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Slide(GuidedPart):
    """``m v' = sum of forces``, among them ``viscous v + coulomb tanh(v / smoothing)`` of its guide.

    The equations are those of a body, with kg, N and m. Below the smoothing speed it creeps where a guide sticks.
    """

    on_shaft: ClassVar[bool] = True
    in_a_line: ClassVar[bool] = True

    kind: Literal["slide"] = "slide"
    mass: Annotated[float, Parameter("kg", "mass", above=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return mass and friction."""
        node = rig.node(self.name)
        guide = Friction(
            name=f"{self.name}.guide",
            on=node,
            viscous=self.viscous,
            coulomb_forward=self.coulomb,
            coulomb_backward=self.coulomb,
            static_forward=self.coulomb,
            static_backward=self.coulomb,
            smoothing=self.smoothing,
        )
        return Inertia(node=node, inertia=self.mass), guide
