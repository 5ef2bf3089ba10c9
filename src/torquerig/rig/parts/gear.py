"""A gear stage of any ratio: planetary, spur or belt, as a spring with losses between two shafts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.part import Part
from torquerig.rig.rig import Rig
from torquerig.rig.terms import Inertia, Spring, Term
from torquerig.signals.teeth import Planetary, Spur


@dataclass(frozen=True, kw_only=True)
class Gear(Part):
    """Stiffness, damping and backlash are counted at the output; the efficiency acts on the transmitted torque.

    Data sheets give the inertia J1 of the whole gearbox referred to its input and not where it sits; it is put on the
    output side of the spring as J1 ratio^2, as the reference rig has it. Which side matters only above the mode of the
    gearbox on its own spring (700 Hz on the wear rig; measured difference at the sensor below 500 Hz: under 0.4 dB).

    ``teeth`` is kinematics (it says where mesh lines would stand); no mesh torque comes from it without a GearMesh.
    """

    on_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True

    kind: Literal["gear"] = "gear"
    ratio: Annotated[float, Parameter("1", "input turns per output turn")]
    stiffness: Annotated[float, Parameter("N*m/rad", "stiffness at the output", above=0)]
    damping: Annotated[float, Parameter("N*m*s/rad", "damping at the output", low=0)]
    efficiency: Annotated[float, Parameter("1", "efficiency", above=0, high=1)] = 1.0
    backlash: Annotated[float, Parameter("rad", "full backlash at the output", low=0)] = 0.0
    input_inertia: Annotated[float, Parameter("kg*m^2", "inertia referred to the input (J1)", low=0)] = 0.0
    output_inertia: Annotated[float, Parameter("kg*m^2", "inertia on the output shaft", low=0)] = 0.0
    teeth: tuple[Planetary | Spur, ...] = ()

    def __post_init__(self) -> None:
        if self.ratio == 0:
            raise ValueError("a gear of ratio 0 transmits nothing; write the input turns per output turn, such as 5")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the inertias of both sides and the spring between, with the errors and gaps that effects add."""
        upstream, node = rig.upstream(self.name), rig.node(self.name)
        error = tuple(wave for part in rig.parts for wave in part.kinematic_error(self.name))
        gap = self.backlash + sum(part.extra_gap(self.name) for part in rig.parts)
        return (
            Inertia(node=node, inertia=self.output_inertia + self.input_inertia * self.ratio**2),
            Spring(
                name=self.name,
                a=upstream,
                b=node,
                stiffness=self.stiffness,
                damping=self.damping,
                gap=gap,
                ratio=self.ratio,
                efficiency=self.efficiency,
                error=error,
            ),
        )
