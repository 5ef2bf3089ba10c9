"""A gear stage, planetary or fixed-axis, by its ratio or its tooth counts: a spring with losses between two shafts."""

from __future__ import annotations

from dataclasses import dataclass
from math import copysign, prod
from typing import Annotated, ClassVar, Literal

from torquerig.orders.kinematics.planetary_assembly import RATIO_KEPT, assembly_remedy, nearest_sets
from torquerig.orders.kinematics.teeth import Planetary, Spur
from torquerig.orders.kinematics.teeth_reading import TeethList
from torquerig.parameter import Parameter
from torquerig.rig.assembly import Rig
from torquerig.rig.bearing import BearingPart
from torquerig.rig.host_changes import IN_A_SPRING, HostChange
from torquerig.rig.stage_spring import stage_spring
from torquerig.rig.terms import Inertia, Term


@dataclass(frozen=True, kw_only=True)
class Gear(BearingPart):
    """``T = k (theta_in / N - theta_out + e)``, for every kind of teeth: they determine N and the orders of mesh lines.

    Stiffness, damping and backlash are counted at the output; the efficiency acts on the transmitted torque.
    ``planetary_gear`` and ``fixed_axis_gear`` are gears whose teeth are stated; their ratio follows (1 + ring/sun with
    a fixed ring, -ring/sun with a fixed carrier, 1 + sun/ring with a fixed sun; -wheel/pinion, or wheel/pinion into a
    ring). A stated ratio must agree within 2 % (it is rounded): the teeth then give its value, and it gives the sign.

    Data sheets give the inertia J1 of the whole gearbox referred to its input and not where it sits; it is put on the
    output side of the spring as J1 ratio^2, as the reference rig has it. Which side matters only above the mode of the
    gearbox on its own spring (700 Hz on the wear rig; measured difference at the sensor below 500 Hz: under 0.4 dB).

    Teeth are kinematics; no mesh torque comes from them without a ToothMesh or GearMesh.
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True
    takes: ClassVar[tuple[type[HostChange], ...]] = IN_A_SPRING

    kind: Literal["gear", "planetary_gear", "fixed_axis_gear"] = "gear"
    ratio: Annotated[float, Parameter("1", "input turns per output turn; 0: the teeth say")] = 0.0
    stiffness: Annotated[float, Parameter("N*m/rad", "stiffness at the output", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "damping at the output", low=0)]
    efficiency: Annotated[float, Parameter("1", "efficiency", above=0, high=1)] = 1.0
    backlash: Annotated[float, Parameter("rad", "full backlash at the output", low=0)] = 0.0
    input_inertia: Annotated[float, Parameter("kg*m^2", "inertia referred to the input (J1)", low=0)] = 0.0
    output_inertia: Annotated[float, Parameter("kg*m^2", "inertia on the output shaft", low=0)] = 0.0
    rest_angle: Annotated[
        float, Parameter("rad", "input angle / ratio less output angle without torque, in the middle of the backlash")
    ] = 0.0
    teeth: Annotated[tuple[Planetary | Spur, ...], TeethList()] = ()

    def __post_init__(self) -> None:
        wanted = {"planetary_gear": Planetary, "fixed_axis_gear": Spur}.get(self.kind)
        if wanted and not (self.teeth and all(isinstance(stage, wanted) for stage in self.teeth)):
            counts = "{sun: 21, ring: 84, planets: 3}" if wanted is Planetary else "{pinion: 20, wheel: 50}"
            raise ValueError(f"a {self.kind} needs its tooth counts; write for example teeth: {counts}")
        if self.ratio == 0 and not self.teeth:
            raise ValueError("a gear of ratio 0 transmits nothing; write the input turns per output turn, such as 5, "
                             "or its teeth")  # fmt: skip
        by_teeth = prod(-stage.ratio if stage.reverses else stage.ratio for stage in self.teeth)
        if self.ratio == 0:
            object.__setattr__(self, "ratio", by_teeth)
        elif self.teeth and abs(abs(by_teeth / self.ratio) - 1) > RATIO_KEPT:
            raise ValueError(
                f"the teeth give a ratio of {abs(by_teeth):.4g}, but ratio is {self.ratio:g}; correct one of them"
                + self._nearest()
            )
        elif self.teeth:
            object.__setattr__(self, "ratio", copysign(by_teeth, self.ratio))

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the inertias of both sides and the spring between, with the errors and gaps that effects add."""
        inertia = self.output_inertia + self.input_inertia * self.ratio**2
        spring = stage_spring(
            rig, self.name, stiffness=self.stiffness, damping=self.damping, gap=self.backlash, ratio=self.ratio,
            efficiency=self.efficiency, rest=self.rest_angle,
            smoothing=self.smoothing,
        )  # fmt: skip
        return Inertia(node=spring.b, inertia=inertia), spring, *self.friction_on(spring.b)

    def _nearest(self) -> str:
        """Return the sets of teeth that would give the stated ratio, for a planetary gear of one stage."""
        if len(self.teeth) != 1 or not isinstance(self.teeth[0], Planetary):
            return ""
        one, ratio = self.teeth[0], abs(self.ratio)
        near = nearest_sets(one.sun, one.ring, one.planets, ratio=ratio, fixed=one.fixed)
        return "; " + assembly_remedy(near, ratio, one.fixed)
