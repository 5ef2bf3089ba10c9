"""Speed course: a torque in the reading that follows the speed by no law; a description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.speed_course import SpeedCourse as Course


@dataclass(frozen=True, kw_only=True)
class SpeedCourse(Part):
    """``T += s c(|w|) sign(w)``, w the motor's speed: c is a straight line above a kink, or a window of speeds.

    A diagnosis uses it for mean torques that follow the speed as no other effect of the library does. c is
    ``max(|w| / at - 1, 0)`` (kink) or ``exp(-(|w| / at - 1)^2 / (2 b^2))`` with b = 0.07 (window). The shapes are
    empirical; not valid for what follows another quantity that changes with the speed. Source: the two simplest
    departures from a smooth curve, a spline of degree 1 with one knot and one radial basis function (Hastie,
    Tibshirani & Friedman 2009, The Elements of Statistical Learning, 5.2 and 6.7).
    """

    kind: Literal["speed_course"] = "speed_course"
    group: Literal["sensor"] = "sensor"
    shape: Literal["kink", "window"]
    at: Annotated[float, Parameter("rad/s", "speed of the motor at the kink or in the middle of the window", above=0)]
    size: Annotated[float, Parameter("N*m", "torque at twice the speed of the kink, or in the middle")] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the torque, in the reading alone."""
        course = Course(shape=self.shape, at=self.at, size=self.size)
        return (PlacedStage(position=PlacedStage.MECHANICAL, stage=course),)
