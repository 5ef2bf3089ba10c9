"""Bending cross-talk: the sensor reads bending of its shaft as torque, once a turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.rig.turns import turns_per_motor_turn
from torquerig.sensor_stages.crosstalk import Crosstalk

GRAVITY = 9.80665  # [m/s^2] standard gravity, 3rd CGPM 1901


@dataclass(frozen=True, kw_only=True)
class BendingCrosstalk(Part):
    """``T += A cos(theta + phi_1) + B cos(2 theta + phi_2) + C w^2 cos(theta + phi_3)``, in the reading alone.

    A is c M_b: state it as measured (``once``), or state the weight that bends the sensor, its lever and the cross-talk
    coefficient c of the data sheet, A = c m g l; with the mass off its axis by x, C = c m x l. B is an oval body, as
    measured. Turning the sensor against the coupling turns the phase. Source: signatures.md 6.4 (0.05 to 1 % of full
    scale), 3.1. Not valid where bearings near the sensor carry the weight.
    """

    kind: Literal["bending_crosstalk"] = "bending_crosstalk"
    group: Literal["sensor"] = "sensor"
    sensor: str = "torque_sensor"
    once: Annotated[float, Parameter("N*m", "line once a turn", low=0)] = 0.0
    twice: Annotated[float, Parameter("N*m", "line twice a turn", low=0)] = 0.0
    once_by_speed_squared: Annotated[
        float, Parameter("N*m*s^2/rad^2", "line once a turn that grows with speed squared", low=0)
    ] = 0.0

    coefficient: Annotated[float, Parameter("1", "reading per bending moment", low=0)] = 0.0
    mass: Annotated[float, Parameter("kg", "what hangs on the sensor", low=0)] = 0.0
    lever: Annotated[float, Parameter("m", "its distance from the sensor's body", low=0)] = 0.0
    mass_eccentricity: Annotated[float, Parameter("m", "its centre of mass off the axis", low=0)] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the lines, by the true angle of the sensor's shaft."""
        bending = Crosstalk(
            once=self.once + self.coefficient * self.mass * GRAVITY * self.lever,
            twice=self.twice,
            once_by_speed_squared=self.once_by_speed_squared
            + self.coefficient * self.mass * self.mass_eccentricity * self.lever,
            turns=turns_per_motor_turn(rig, self.sensor),
            source=self.name,
        )
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=bending),)
