"""Bearing defect: impacts of a pitted race or ball, each of which rings a local mode."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.sensor_stages.ringing import Ringing


@dataclass(frozen=True, kw_only=True)
class BearingDefect(Part):
    """An impact each 1/order of a turn of ``at``: ``T += sum_k A exp(-2 pi zeta f t_k) sin(2 pi f t_k)`` at the sensor.

    t_k is the time since impact k. State the order, or the bearing (n balls of diameter d on the pitch diameter D at
    contact angle a) and its ``fault``: ``n/2 (1 -+ d/D cos a)`` for the outer (-, BPFO) and inner (+, BPFI) race,
    ``D/(2 d) (1 - (d/D cos a)^2)`` for a ball (BSF; one race, twice that where it strikes both) and
    ``(1 - d/D cos a)/2`` for the cage (FTF), the outer race fixed. Source: Randall & Antoni 2011, MSSP 25(2); Harris &
    Kotzalas, Rolling Bearing Analysis. The amplitude A is a measured one. The mode is local: the shafts do not move
    with it, and A is what reaches the sensor; balls slip by 1 to 2 %. Not valid where impacts grow with the speed.
    """

    kind: Literal["bearing_defect"] = "bearing_defect"
    group: Literal["sensor"] = "sensor"
    at: str = "wear_part"
    order_output: Annotated[float, Parameter("1", "impacts per turn; 0: the bearing says", low=0)] = 0.0
    fault: Literal["outer", "inner", "ball", "cage"] | None = None
    balls: int | None = None
    ball_diameter: Annotated[float, Parameter("m", "diameter of a ball", above=0)] | None = None
    pitch_diameter: Annotated[float, Parameter("m", "diameter of the circle of ball centres", above=0)] | None = None
    contact_angle: Annotated[float, Parameter("rad", "contact angle", low=0, high=pi / 3)] = 0.0
    ring_frequency: Annotated[float, Parameter("Hz", "frequency of the mode that rings", above=0)]
    damping: Annotated[float, Parameter("1", "damping ratio of that mode", above=0, high=1)] = 0.05
    amplitude: Annotated[float, Parameter("N*m", "start of each ringing, at the sensor", low=0)]
    slip: Annotated[float, Parameter("1", "relative sd of the angle between impacts", low=0, high=0.2)] = 0.0
    load_zone: Annotated[float, Parameter("1", "modulation once a turn", low=0, high=1)] = 0.0

    def __post_init__(self) -> None:
        bearing = (self.fault, self.balls, self.ball_diameter, self.pitch_diameter)
        if (None in bearing) == (self.order_output == 0) or (self.order_output and any(bearing)):
            raise ValueError(
                "state either order_output, or fault, balls, ball_diameter and pitch_diameter; the one gives the other"
            )
        if self.ball_diameter and self.pitch_diameter and self.balls and not self._fits():
            raise ValueError(
                f"{self.balls} balls of {self.ball_diameter:g} m do not fit on a circle of {self.pitch_diameter:g} m; "
                "correct one of the three"
            )

    @property
    def order(self) -> float:
        """Impacts per turn of the shaft [1/rev]: as stated, or from the bearing."""
        if self.fault is None:
            return self.order_output
        slim = (self.ball_diameter or 0.0) / (self.pitch_diameter or 1.0) * cos(self.contact_angle)
        balls, across = self.balls or 0, (self.pitch_diameter or 1.0) / (self.ball_diameter or 1.0)
        orders = {"outer": balls * (1 - slim), "inner": balls * (1 + slim), "cage": 1 - slim}
        return 0.5 * (orders | {"ball": across * (1 - slim**2)})[self.fault]

    def _fits(self) -> bool:
        return (self.balls or 0) * (self.ball_diameter or 0.0) <= pi * (self.pitch_diameter or 0.0)

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the ringing, timed by the true angle of the shaft."""
        ringing = Ringing(
            order=self.order,
            frequency=self.ring_frequency,
            damping=self.damping,
            amplitude=self.amplitude,
            slip=self.slip,
            load_zone=self.load_zone,
            turns=turns_per_motor_turn(rig, self.at),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=ringing),)
