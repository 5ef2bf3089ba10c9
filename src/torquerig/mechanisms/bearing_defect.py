"""Bearing defect: impacts of a pitted race or ball, each of which rings a local mode."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.part import Part, PlacedStage
from torquerig.rig.rig import Rig
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.signals.stages.ringing import Ringing


@dataclass(frozen=True, kw_only=True)
class BearingDefect(Part):
    """An impact each 1/order of a turn of ``at``: ``T += sum_k A exp(-2 pi zeta f t_k) sin(2 pi f t_k)`` at the sensor.

    t_k is the time since impact k. For n balls of diameter d on the pitch diameter D at contact angle a, the order is
    ``n/2 (1 -+ d/D cos a)`` for the outer (-) and inner (+) race, ``D/(2 d) (1 - (d/D cos a)^2)`` for a ball. Source:
    Randall & Antoni 2011, MSSP 25(2); Harris & Kotzalas, Rolling Bearing Analysis. The mode is local: the shafts do
    not move with it, and A is what reaches the sensor, at any speed (real impacts grow with speed).
    """

    kind: Literal["bearing_defect"] = "bearing_defect"
    group: Literal["sensor"] = "sensor"
    at: str = "wear_part"
    order_output: Annotated[float, Parameter("1", "impacts per turn", above=0)]
    ring_frequency: Annotated[float, Parameter("Hz", "frequency of the mode that rings", above=0)]
    damping: Annotated[float, Parameter("1", "damping ratio of that mode", above=0, high=1)] = 0.05
    amplitude: Annotated[float, Parameter("N*m", "start of each ringing, at the sensor", low=0)]
    slip: Annotated[float, Parameter("1", "relative spread of the way between impacts", low=0, high=0.2)] = 0.0
    load_zone: Annotated[float, Parameter("1", "modulation once a turn", low=0, high=1)] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the ringing, timed by the true angle of the shaft."""
        ringing = Ringing(
            order=self.order_output,
            frequency=self.ring_frequency,
            damping=self.damping,
            amplitude=self.amplitude,
            slip=self.slip,
            load_zone=self.load_zone,
            turns=turns_per_motor_turn(rig, self.at),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=ringing),)
