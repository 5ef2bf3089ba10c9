"""Reading course: zero or gain of a reading change during each recording; an empirical description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from torquerig.parameter import Parameter
from torquerig.rig.assembly import Part, Rig
from torquerig.rig.placed_stage import PlacedStage
from torquerig.sensor_stages.course import Course


@dataclass(frozen=True, kw_only=True)
class ReadingCourse(Part):
    """``V (1 + g c(x)) + z c(x)``, x the share of a recording that is over: c is a step, a ramp or a settling.

    A diagnosis uses it for mean torques that change during each recording as no other effect of the library does.
    c is 1 after x = ``at`` (step), ``(x - at) / (1 - at)`` after it (ramp), or ``1 - exp(-x / at)`` (settling). The
    shapes are empirical; not valid where the change comes at another moment of each recording. Source: instrumental
    drift as JCGM 200:2012, 4.21, defines it: a change of the indication that no change of the torque makes.
    """

    kind: Literal["reading_course"] = "reading_course"
    group: Literal["sensor"] = "sensor"
    shape: Literal["step", "ramp", "settling"]
    at: Annotated[float, Parameter("1", "share of a recording when it changes, or constant of the settling", above=0)]
    zero: Annotated[float, Parameter("V", "change of the zero")] = 0.0
    gain: Annotated[float, Parameter("1", "relative change of the gain", above=-1)] = 0.0

    def stages(self, rig: Rig) -> tuple[PlacedStage, ...]:
        """Return the course."""
        course = Course(shape=self.shape, at=self.at, zero=self.zero, gain=self.gain)
        return (PlacedStage(position=PlacedStage.CABLE, stage=course),)
