"""Imbalance: gravity on a part whose centre of mass is off the axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

GRAVITY = 9.80665  # [m/s^2] standard gravity, 3rd CGPM 1901


@dataclass(frozen=True, kw_only=True)
class Imbalance(Part):
    """``T = m g e cos(theta + phi)`` on the horizontal shaft of ``at``: once a turn, the same at any speed.

    1 kg with 0.1 mm makes 1 mN m. The inertia of the mass belongs to the part itself. Source: statics; ISO 21940-11 for
    sizes of e. What grows with the square of speed loads the bearings and reaches the reading by bending only
    (bending_crosstalk). Not valid for a vertical shaft.
    """

    acts_from_outside: ClassVar[bool] = True

    kind: Literal["imbalance"] = "imbalance"
    group: Literal["mechanical"] = "mechanical"
    at: str = "wear_part"
    mass: Annotated[float, Parameter("kg", "mass of the part", low=0)]
    eccentricity: Annotated[float, Parameter("m", "distance of its centre of mass from the axis", low=0)]
    phase: float | None = None

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the weight's torque against the frame."""
        node = rig.node(self.at)
        torque = self.mass * GRAVITY * self.eccentricity
        waves = (Wave(order=1.0, amplitude=torque, phase=self.phase),) if torque else ()
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=waves),)
