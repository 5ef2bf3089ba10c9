"""Cogging: the torque between magnets and teeth, at whole motor orders and without current."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import lcm
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.part import Part
from torquerig.rig.rig import Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

Torque = Annotated[float, Parameter("N*m", "zero-to-peak cogging torque", low=0)]


@dataclass(frozen=True, kw_only=True)
class Cogging(Part):
    """``T = sum A cos(order theta + phi)`` at LCM(Q, 2p) (native), Q (unequal magnets) and 2p (unequal teeth).

    Independent of current and speed. Source: Zhu & Howe 2000, IEEE Trans. Energy Conversion 15(4), for the native
    order; Gasparin et al. 2009, IEEE Trans. Magnetics 45(3), for the tolerance orders. ``further`` holds multiples of
    the three by their order. Phases not stated are drawn by the seed. The amplitudes are measured
    ones (a slow turn without current, or a data sheet); from an offset rotor they follow in eccentricity. Not true
    where skew or saturation under load changes them.
    """

    kind: Literal["cogging"] = "cogging"
    at: str = "motor"
    group: Literal["cogging"] = "cogging"
    slots: int
    pole_pairs: int
    native: Torque = 0.0
    unequal_magnets: Torque = 0.0
    unequal_teeth: Torque = 0.0
    further: dict[int, Torque] = field(default_factory=dict)
    phases: dict[int, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.slots < 1 or self.pole_pairs < 1:
            raise ValueError(f"{self.slots} slots and {self.pole_pairs} pole pairs cannot be; both are at least 1")
        for order in self.further:
            if order < 1 or (order % self.slots and order % (2 * self.pole_pairs)):
                raise ValueError(
                    f"further: {order} is no multiple of {self.slots} slots or {2 * self.pole_pairs} poles; "
                    "write a line of another cause as torque_ripple"
                )

    def amplitudes(self) -> dict[int, float]:
        """Return the amplitude [N m] by motor order; equal orders (Q = 2p never, LCM = Q possible) add up."""
        orders: dict[int, float] = {}
        for order, amplitude in (
            (lcm(self.slots, 2 * self.pole_pairs), self.native),
            (self.slots, self.unequal_magnets),
            (2 * self.pole_pairs, self.unequal_teeth),
            *self.further.items(),
        ):
            orders[order] = orders.get(order, 0.0) + amplitude
        return {order: amplitude for order, amplitude in orders.items() if amplitude > 0}

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the lines between rotor and frame."""
        node = rig.node(self.at)
        waves = tuple(
            Wave(order=order, amplitude=amplitude, phase=self.phases.get(order))
            for order, amplitude in self.amplitudes().items()
        )
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=waves),)
