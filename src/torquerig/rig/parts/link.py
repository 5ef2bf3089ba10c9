"""A rod, belt or spring between two things that move in a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import GuidedPart
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Link(GuidedPart):
    """``F = k (x_a - x_b - rest_offset) + c (v_a - v_b)``, positive when pushed together; with free play if stated."""

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    in_a_line: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["link"] = "link"
    stiffness: Annotated[float, Parameter("N/m", "stiffness", above=0)]
    damping: Annotated[float, Parameter("N*s/m", "damping", low=0)]
    play: Annotated[float, Parameter("m", "full free play", low=0)] = 0.0
    mass: Annotated[float, Parameter("kg", "mass of the far side", low=0)] = 0.0
    rest_offset: Annotated[float, Parameter("m", "near less far position without force, in the middle of the play")] = (
        0.0
    )

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the spring, and mass and friction of its far side."""
        spring = stage_spring(
            rig, self.name, stiffness=self.stiffness, damping=self.damping, gap=self.play, rest=self.rest_offset
        )
        return Inertia(node=spring.b, inertia=self.mass), spring, *self.friction_on(spring.b)
