"""Bending cross-talk: the sensor reads bending of its shaft as torque, once a turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.part import Part, PlacedStage
from torquerig.rig.rig import Rig
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.signals.stages.crosstalk import Crosstalk


@dataclass(frozen=True, kw_only=True)
class BendingCrosstalk(Part):
    """``T += A cos(theta + phi_1) + B cos(2 theta + phi_2) + C w^2 cos(theta + phi_3)``, in the reading alone.

    A is c M_b, the weight's bending moment times the cross-talk coefficient; B an oval body; C an unbalance. Turning
    the sensor against the coupling turns the phase. Source: signatures.md 6.4 (0.05 to 1 % of full scale), 3.1.
    """

    kind: Literal["bending_crosstalk"] = "bending_crosstalk"
    group: Literal["sensor"] = "sensor"
    sensor: str = "torque_sensor"
    once: Annotated[float, Parameter("N*m", "line once a turn", low=0)]
    twice: Annotated[float, Parameter("N*m", "line twice a turn", low=0)] = 0.0
    once_by_speed_squared: Annotated[
        float, Parameter("N*m*s^2/rad^2", "line once a turn that grows with speed squared", low=0)
    ] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the lines, by the true angle of the sensor's shaft."""
        bending = Crosstalk(
            once=self.once,
            twice=self.twice,
            once_by_speed_squared=self.once_by_speed_squared,
            turns=turns_per_motor_turn(rig, self.sensor),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=bending),)
