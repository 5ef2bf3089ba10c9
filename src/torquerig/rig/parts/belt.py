"""A belt stage: two pulleys and a belt, whose strands are the spring between the shafts."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Annotated, ClassVar, Literal

from torquerig.errors import InputError
from torquerig.orders.kinematics.belt import Belt
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class BeltStage(BearingPart):
    """``T = k (theta_in / N - theta_out + e)`` with ``k = 2 (EA / l) r^2`` and ``c = 2 d r^2`` at the output pulley.

    N is wheel over pinion, r the pitch radius of the output pulley, l the free strand (from the belt's length), EA the
    belt's force per strain, as makers state it for tension members, d the damping of a strand. Both strands pull
    while the pretension keeps them tight; each pulley's inertia sits on its own shaft. State either tooth counts with
    the pitch, or the pitch diameters with the belt's length. Source: signatures.md 3.7; ISO 5296; springs in parallel.
    Not true where a strand goes slack, where teeth jump, or where a smooth belt creeps (its ratio is then a little
    higher).
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["belt"] = "belt"
    pinion_teeth: int | None = None
    wheel_teeth: int | None = None
    belt_teeth: int | None = None
    pitch: Annotated[float, Parameter("m", "pitch of the teeth", above=0)] | None = None
    pinion_diameter: Annotated[float, Parameter("m", "pitch diameter of the input pulley", above=0)] | None = None
    wheel_diameter: Annotated[float, Parameter("m", "pitch diameter of the output pulley", above=0)] | None = None
    belt_length: Annotated[float, Parameter("m", "length of a smooth belt", above=0)] | None = None
    belt_stiffness: Annotated[float, Parameter("N", "force per strain of the belt (EA)", above=0)]
    strand_damping: Annotated[float, Parameter("N*s/m", "damping of one strand", low=0)]
    efficiency: Annotated[float, Parameter("1", "efficiency", above=0, high=1)] = 1.0
    pinion_inertia: Annotated[float, Parameter("kg*m^2", "inertia of the input pulley", low=0)] = 0.0
    wheel_inertia: Annotated[float, Parameter("kg*m^2", "inertia of the output pulley", low=0)] = 0.0
    rest_angle: Annotated[float, Parameter("rad", "input angle / ratio less output angle without torque")] = 0.0

    def __post_init__(self) -> None:
        toothed = (self.pinion_teeth, self.wheel_teeth, self.belt_teeth, self.pitch)
        smooth = (self.pinion_diameter, self.wheel_diameter, self.belt_length)
        if (None in toothed) == (None in smooth) or any(
            x is not None for x in (toothed if None in toothed else smooth)
        ):
            raise ValueError(
                "a belt needs either pinion_teeth, wheel_teeth, belt_teeth and pitch, or pinion_diameter, "
                "wheel_diameter and belt_length; state all of one kind and none of the other"
            )
        try:
            self.geometry()
        except InputError as error:
            raise ValueError(str(error)) from None

    def geometry(self) -> Belt:
        """Return rims and belt, in teeth where it is toothed and in metres where it is smooth."""
        if self.pinion_teeth is not None and self.wheel_teeth is not None and self.belt_teeth is not None:
            return Belt(self.pinion_teeth, self.wheel_teeth, self.belt_teeth)
        rims = pi * (self.pinion_diameter or 0.0), pi * (self.wheel_diameter or 0.0)
        return Belt(*rims, self.belt_length or 0.0, toothed=False)

    @property
    def ratio(self) -> float:
        """Turns of the input pulley per turn of the output pulley [1]."""
        return self.geometry().ratio

    @property
    def teeth(self) -> tuple[Belt, ...]:
        """The stage as the orders need it; empty for a smooth belt."""
        return (self.geometry(),) if self.pitch else ()

    @property
    def stiffness(self) -> float:
        """Torsional stiffness at the output pulley [N m/rad]."""
        return 2 * self.belt_stiffness / (self.geometry().strand() * self._unit) * self.wheel_radius**2

    @property
    def damping(self) -> float:
        """Torsional damping at the output pulley [N m s/rad]."""
        return 2 * self.strand_damping * self.wheel_radius**2

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the pulleys and the spring between, with the errors that effects add."""
        spring = stage_spring(
            rig, self.name, stiffness=self.stiffness, damping=self.damping, rest=self.rest_angle, ratio=self.ratio,
            efficiency=self.efficiency,
            smoothing=self.smoothing,
        )  # fmt: skip
        pinion = Inertia(node=rig.upstream(self.name), inertia=self.pinion_inertia)
        return pinion, Inertia(node=spring.b, inertia=self.wheel_inertia), spring, *self.friction_on(spring.b)

    @property
    def _unit(self) -> float:
        return self.pitch or 1.0

    @property
    def wheel_radius(self) -> float:
        """Pitch radius of the output pulley [m]."""
        return self.geometry().wheel * self._unit / (2 * pi)
