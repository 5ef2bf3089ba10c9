"""Measured torque lines of a shaft: amplitude by order, whatever their cause."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.terms import HarmonicTorque, Term, Wave

Torque = Annotated[float, Parameter("N*m", "zero-to-peak torque of a line", low=0)]


@dataclass(frozen=True, kw_only=True)
class TorqueRipple(Part):
    """``T = sum_k A_k cos(k theta + phi_k)`` on the shaft of the part ``at``; phases not stated are drawn at random.

    An effect with measured amplitudes: it states a line and does not explain it. Where occupancy damps the lines (as
    observed in the reference report, section 4.1), they are divided by ``1 + relief_per_percent * occupancy_percent``.
    ``amplitude_rel_sd`` is the relative standard deviation within which a calibration may change each amplitude.

    Source: the reference report's families, eq. 3.1-3.4 and Table I. Not true at another speed or load than that of the
    measurement, where the cause changes with it.
    """

    kind: Literal["torque_ripple"] = "torque_ripple"
    at: str
    group: Literal["mechanical", "cogging", "electrical"]
    amplitudes: dict[float, Torque]
    phases: dict[float, float] = field(default_factory=dict)
    relief_per_percent: Annotated[float, Parameter("1", "relief per percent of occupancy", low=0)] = 0.0
    amplitude_rel_sd: Annotated[float, Parameter("1", "relative standard deviation of the amplitudes", low=0)] = 0.0

    def __post_init__(self) -> None:
        for order in self.amplitudes:
            if not order > 0:
                raise ValueError(f"{order:g} is no order of a line; an order is more than 0")

    def terms(self, rig: Rig) -> tuple[Term, ...]:
        """Return the lines at the shaft's orders."""
        node = rig.node(self.at)
        relief = 1 + self.relief_per_percent * (rig.run.occupancy_percent or 0.0)
        waves = tuple(
            Wave(order=order, amplitude=amplitude / relief, phase=self.phases.get(order))
            for order, amplitude in self.amplitudes.items()
        )
        return (HarmonicTorque(name=self.name, on=node, angle=node, waves=waves),)
