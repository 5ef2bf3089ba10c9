"""A linear drive: a ball screw, a rack or a belt that turns rotation into motion in a line."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi
from typing import Annotated, ClassVar, Literal

from torquerig.orders.kinematics.teeth import Spur
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import GuidedPart
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term, Wave


@dataclass(frozen=True, kw_only=True)
class LinearDrive(GuidedPart):
    """``F = k (lead theta / 2 pi - x + e) + c d/dt(...)``, on the shaft ``F lead / (2 pi eta)``.

    ``lead`` is the travel per turn of the shaft before it: the lead of a screw, teeth times pitch of a belt's pulley,
    pi times the pitch diameter of a pinion on a rack; negative where a positive turn moves it back. Stiffness, damping
    and play are those of everything between the shaft and what moves (screw, nut and bearings in series), ``mass`` is
    the nut's. ``lead_error`` is the periodic travel deviation, harmonic by harmonic of the shaft's turn:
    ``e = sum a_k cos(2 pi k x / lead + phi_k)``.

    Source: ISO 3408-1 and -3 for lead and travel deviation; ISO 3408-4 for the series of axial stiffnesses. Not true
    where the stiffness depends on the position of the nut by much (a long slender screw), and for self-locking screws.
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    in_a_line: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING
    teeth: ClassVar[tuple[Spur, ...]] = ()

    kind: Literal["linear_drive"] = "linear_drive"
    lead: Annotated[float, Parameter("m", "travel per turn of the shaft")]
    stiffness: Annotated[float, Parameter("N/m", "stiffness in the direction of travel", above=0)]
    damping: Annotated[float, Parameter("N*s/m", "damping in the direction of travel", low=0)]
    efficiency: Annotated[float, Parameter("1", "efficiency", above=0, high=1)] = 1.0
    play: Annotated[float, Parameter("m", "full free play", low=0)] = 0.0
    input_inertia: Annotated[float, Parameter("kg*m^2", "inertia of screw, pulley or pinion", low=0, turns=True)] = 0.0
    mass: Annotated[float, Parameter("kg", "mass of the nut", low=0)] = 0.0
    lead_error: tuple[
        Annotated[float, Parameter("m", "zero-to-peak travel deviation of a harmonic of the turn", low=0)], ...
    ] = ()
    rest_offset: Annotated[float, Parameter("m", "lead times turns less position without force")] = 0.0

    def __post_init__(self) -> None:
        if self.lead == 0:
            raise ValueError("a linear drive of lead 0 moves nothing; write the travel per turn, such as 10 mm")

    @property
    def ratio(self) -> float:
        """Angle of the shaft per travel [rad/m]."""
        return 2 * pi / self.lead

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return screw, nut and the spring between, with the errors and gaps that effects add."""
        spring = stage_spring(
            rig, self.name, stiffness=self.stiffness, damping=self.damping, gap=self.play, ratio=self.ratio,
            efficiency=self.efficiency, rest=self.rest_offset,
            smoothing=self.smoothing,
        )  # fmt: skip
        own = tuple(
            Wave(order=harmonic * abs(self.ratio), amplitude=error, phase_key=f"{self.name}.lead_error.{harmonic}")
            for harmonic, error in enumerate(self.lead_error, start=1)
            if error
        )
        screw = Inertia(node=rig.upstream(self.name), inertia=self.input_inertia)
        error = (*spring.error, *own)
        return (
            screw,
            Inertia(node=spring.b, inertia=self.mass),
            replace(spring, error=error),
            *self.friction_on(spring.b),
        )
