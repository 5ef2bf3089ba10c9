"""A further inertia on a spring: a torsional mode that the nominal rig lacks."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Inertia, Spring, Term


@dataclass(frozen=True, kw_only=True)
class TorsionalMode(Part):
    """Inertia J2 hung on the shaft of ``after`` by ``k = J2 (2 pi f)^2`` and ``c = 2 zeta sqrt(k J2)``.

    f is the natural frequency of the branch clamped at its root. Source: any text on vibration absorbers, for example
    Den Hartog, Mechanical Vibrations, section 3.2.
    """

    on_shaft: ClassVar[bool] = True
    ends_shaft: ClassVar[bool] = True
    opens_node: ClassVar[bool] = True

    kind: Literal["torsional_mode"] = "torsional_mode"
    frequency: Annotated[float, Parameter("Hz", "frequency of the clamped branch", above=0)]
    inertia: Annotated[float, Parameter("kg*m^2", "inertia of the branch", above=0)]
    damping_ratio: Annotated[float, Parameter("1", "damping ratio of the clamped branch", low=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the branch."""
        stiffness = self.inertia * (2 * pi * self.frequency) ** 2
        damping = 2 * self.damping_ratio * sqrt(stiffness * self.inertia)
        node = rig.node(self.name)
        spring = Spring(name=self.name, a=rig.upstream(self.name), b=node, stiffness=stiffness, damping=damping)
        return Inertia(node=node, inertia=self.inertia), spring
