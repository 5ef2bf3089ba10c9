"""A rod, belt or spring between two things that move in a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Link(Part):
    """``F = k (x_a - x_b) + c (v_a - v_b)``, with a free play where stated; positive when pushed together."""

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    in_a_line: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["link"] = "link"
    stiffness: Annotated[float, Parameter("N/m", "stiffness", above=0)]
    damping: Annotated[float, Parameter("N*s/m", "damping", low=0)]
    play: Annotated[float, Parameter("m", "full free play", low=0)] = 0.0
    mass: Annotated[float, Parameter("kg", "mass of the far side", low=0)] = 0.0

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring and the mass of its far side."""
        spring = stage_spring(rig, self.name, stiffness=self.stiffness, damping=self.damping, gap=self.play)
        return Inertia(node=rig.node(self.name), inertia=self.mass), spring
