"""A worm gear: a screw that drives a wheel, with friction that may lock it against being driven back."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan, atan2, cos, pi, tan
from typing import Annotated, ClassVar, Literal

from torquerig.errors import InputError
from torquerig.orders.kinematics.worm import Worm
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class WormGear(BearingPart):
    """``T = k (theta_in / N - theta_out + e)`` with ``N = wheel teeth / starts`` and the losses of sliding flanks.

    With the lead angle g and the friction angle ``r = atan(mu / cos(an))`` (an the normal pressure angle), the
    efficiency is ``tan(g) / tan(g + r)`` where the worm drives, and ``tan(g - r) / tan(g)`` where the wheel drives.
    Where that is 0 or less (g <= r), the gear is self-locking: the wheel cannot drive the worm, and a motor needs
    torque even to lower a load. State the lead angle, or the module and the worm's pitch diameter (``tan(g) = starts
    module / diameter``); and either the friction or the efficiency of the driving worm as data sheets print it.

    Source: Shigley's Mechanical Engineering Design, ch. 13 (eq. 13-46, the same with cosines). Stiffness, damping and
    backlash are counted at the wheel. The friction is taken as one number: not true over a wide range of sliding speed,
    where it falls from about 0.1 to 0.02. A locked wheel creeps by less than 0.05 rad/s, as its friction is smoothed.
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["worm_gear"] = "worm_gear"
    starts: int
    wheel_teeth: int
    lead_angle: Annotated[float, Parameter("rad", "lead angle of the worm", above=0)] | None = None
    module: Annotated[float, Parameter("m", "axial module", above=0)] | None = None
    worm_diameter: Annotated[float, Parameter("m", "pitch diameter of the worm", above=0)] | None = None
    friction: Annotated[float, Parameter("1", "coefficient of friction of the flanks", low=0)] | None = None
    forward_efficiency: Annotated[float, Parameter("1", "efficiency, worm driving", above=0, high=1)] | None = None
    pressure_angle: Annotated[float, Parameter("rad", "normal pressure angle", low=0)] = pi / 9
    reverses: bool = False
    stiffness: Annotated[float, Parameter("N*m/rad", "stiffness at the wheel", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "damping at the wheel", low=0)]
    backlash: Annotated[float, Parameter("rad", "full backlash at the wheel", low=0)] = 0.0
    worm_inertia: Annotated[float, Parameter("kg*m^2", "inertia of the worm", low=0)] = 0.0
    wheel_inertia: Annotated[float, Parameter("kg*m^2", "inertia of the wheel", low=0)] = 0.0
    rest_angle: Annotated[
        float, Parameter("rad", "input angle / ratio less output angle without torque, in the middle of the backlash")
    ] = 0.0

    def __post_init__(self) -> None:
        try:
            self._set()
        except InputError as error:
            raise ValueError(str(error)) from None
        sizes = [one is not None for one in (self.module, self.worm_diameter)]
        if any(sizes) if self.lead_angle is not None else not all(sizes):
            raise ValueError(
                "a worm_gear needs either lead_angle, such as 5 deg, or module and worm_diameter; state one of the two"
            )
        if (self.friction is None) == (self.forward_efficiency is None):
            raise ValueError(
                "a worm_gear needs either friction, such as 0.05, or forward_efficiency, such as 0.7; state one of them"
            )
        if not self.lead < pi / 2 or not self.pressure_angle < pi / 2:
            raise ValueError("a lead angle and a pressure angle are less than 90 degrees; write for example 5 deg")
        if self.lead + self.friction_angle >= pi / 2:
            raise ValueError(
                f"with a friction angle of {self.friction_angle * 180 / pi:.3g} degrees the worm cannot turn the "
                "wheel; write a smaller friction or a larger efficiency"
            )

    @property
    def ratio(self) -> float:
        """Turns of the worm per turn of the wheel, negative where it reverses [1]."""
        return -self._set().ratio if self.reverses else self._set().ratio

    @property
    def teeth(self) -> tuple[Worm, ...]:
        """The stage as the orders need it."""
        return (self._set(),)

    @property
    def lead(self) -> float:
        """Lead angle of the worm [rad]."""
        if self.lead_angle is not None:
            return self.lead_angle
        return atan2(self.starts * (self.module or 0.0), self.worm_diameter or 1.0)

    @property
    def friction_angle(self) -> float:
        """Angle whose tangent is the friction over the cosine of the pressure angle [rad]."""
        if self.friction is not None:
            return atan(self.friction / cos(self.pressure_angle))
        return atan(tan(self.lead) / (self.forward_efficiency or 1.0)) - self.lead

    @property
    def efficiency(self) -> float:
        """Share of the power that arrives where the worm drives [1]."""
        return tan(self.lead) / tan(self.lead + self.friction_angle)

    @property
    def backward_efficiency(self) -> float:
        """Share of the power that arrives where the wheel drives [1]; 0 or less where the gear is self-locking."""
        return tan(self.lead - self.friction_angle) / tan(self.lead)

    @property
    def is_self_locking(self) -> bool:
        """Whether the wheel cannot drive the worm."""
        return self.lead <= self.friction_angle

    @property
    def losses(self) -> str:
        """The losses of both directions as text."""
        back = (
            "it is self-locking, so that the wheel cannot drive it"
            if self.is_self_locking
            else f"{self.backward_efficiency:.0%} where the wheel drives"
        )
        return f"{self.name}: {self.efficiency:.0%} of the power arrives where the worm drives; {back}"

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return worm, wheel and the spring between, with the errors and gaps that effects add."""
        spring = stage_spring(
            rig, self.name, stiffness=self.stiffness, damping=self.damping, gap=self.backlash, ratio=self.ratio,
            efficiency=self.efficiency, backward_efficiency=self.backward_efficiency, rest=self.rest_angle,
            smoothing=self.smoothing,
        )  # fmt: skip
        worm = Inertia(node=rig.upstream(self.name), inertia=self.worm_inertia)
        return worm, Inertia(node=spring.b, inertia=self.wheel_inertia), spring, *self.friction_on(spring.b)

    def _set(self) -> Worm:
        return Worm(self.starts, self.wheel_teeth)
