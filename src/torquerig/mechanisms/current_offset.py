"""Current offset: the drive's current sensors have an offset, which causes a torque line of order p."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

Amperes = Annotated[float, Parameter("A", "offset of a current sensor")]


@dataclass(frozen=True, kw_only=True)
class CurrentOffset(Part):
    """``T = Kt (2/sqrt(3)) sqrt(a^2 + a b + b^2) cos(p theta + phi)``, a and b the offsets of two current sensors.

    The current loop makes the readings right and the currents wrong: seen from the rotor the offset turns at the
    electrical frequency. Independent of load and speed. Source: Chung & Sul 1998, IEEE Trans. Industry Applications
    34(5). Not valid above the bandwidth of the current loop, nor for six-step commutation.
    """

    kind: Literal["current_offset"] = "current_offset"
    group: Literal["electrical"] = "electrical"
    at: str = "motor"
    pole_pairs: int
    torque_constant: Annotated[float, Parameter("N*m/A", "torque per ampere of peak phase current", above=0)]
    offset_a: Amperes
    offset_b: Amperes = 0.0
    phase: float | None = None

    def __post_init__(self) -> None:
        if self.pole_pairs < 1:
            raise ValueError(f"{self.pole_pairs} pole pairs are not possible; write at least 1")

    @property
    def amplitude(self) -> float:
        """Zero to peak at the motor [N m]."""
        a, b = self.offset_a, self.offset_b
        return self.torque_constant * 2 / sqrt(3) * sqrt(a * a + a * b + b * b)

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the line between rotor and frame."""
        node = rig.node(self.at)
        wave = Wave(order=self.pole_pairs, amplitude=self.amplitude, phase=self.phase)
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=(wave,) if self.amplitude else ()),)
