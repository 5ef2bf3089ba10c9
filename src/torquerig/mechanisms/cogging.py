"""Cogging: the torque between magnets and teeth, at whole motor orders and without current."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import lcm
from typing import Annotated, Any, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

Torque = Annotated[float, Parameter("N*m", "zero-to-peak cogging torque", low=0)]


@dataclass(frozen=True, kw_only=True)
class Cogging(Part):
    """``T = sum A cos(order theta + phi)`` at LCM(Q, 2p) (native), Q (unequal magnets) and 2p (unequal teeth).

    Independent of current and speed. Source: Zhu & Howe 2000, IEEE Trans. Energy Conversion 15(4), for the native
    order; Gasparin et al. 2009, IEEE Trans. Magnetics 45(3), for the tolerance orders. ``further`` holds multiples of
    the three by their order. Phases not stated are drawn at random. The amplitudes are measured
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
            raise ValueError(
                f"{self.slots} slots and {self.pole_pairs} pole pairs are not possible; both are at least 1"
            )
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
            *((order, getattr(self, name)) for name, order in self.fixed_orders().items()),
            *self.further.items(),
        ):
            orders[order] = orders.get(order, 0.0) + amplitude
        return {order: amplitude for order, amplitude in orders.items() if amplitude > 0}

    def held_by(self, order: int) -> tuple[str, int | None]:
        """Return the field that holds the amplitude at a motor order, and its key there where it is ``further``."""
        names = [name for name, fixed in self.fixed_orders().items() if fixed == order]
        return (names[0], None) if names else ("further", order)

    def with_amplitudes(self, amplitudes: Mapping[int, float]) -> Cogging:
        """Return the same cogging with these amplitudes [N m] by motor order, and no others."""
        values: dict[str, Any] = {**dict.fromkeys(self.fixed_orders(), 0.0), "further": {}}
        for order, amplitude in amplitudes.items():
            name, key = self.held_by(order)
            if key is None:
                values[name] = amplitude
            else:
                values[name][key] = amplitude
        return replace(self, **values)

    def fixed_orders(self) -> dict[str, int]:
        """Return the motor order of each field that has one order."""
        poles = 2 * self.pole_pairs
        return {"native": lcm(self.slots, poles), "unequal_magnets": self.slots, "unequal_teeth": poles}

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the lines between rotor and frame."""
        node = rig.node(self.at)
        waves = tuple(
            Wave(order=order, amplitude=amplitude, phase=self.phases.get(order))
            for order, amplitude in self.amplitudes().items()
        )
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=waves),)
