"""Quadratic drag: windage and stirring, proportional to the square of the speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import Friction, Term


@dataclass(frozen=True, kw_only=True)
class QuadraticDrag(Part):
    """``load torque += c w |w|`` on the shaft of ``at``: turbulent flow round the part, constant drag coefficient.

    c is a measured one. Source: dimensional analysis at constant drag coefficient (any text on fluid mechanics). Not
    true for slow or viscous flow, whose drag goes with w.
    """

    acts_from_outside: ClassVar[bool] = True

    kind: Literal["quadratic_drag"] = "quadratic_drag"
    group: Literal["load"] = "load"
    at: str = "wear_part"
    coefficient: Annotated[float, Parameter("N*m*s^2/rad^2", "drag coefficient", low=0)]

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the drag against the frame."""
        return (Friction(name=self.name, on=rig.node(self.at), quadratic=self.coefficient),)
