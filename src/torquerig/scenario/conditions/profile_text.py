"""Duty cycles and tables of a scenario's ``operating_point:``."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, StrictBool, field_validator, model_validator

from torquerig.parameter import Parameter
from torquerig.scenario.numbers.percent import Percent

Repeats = Annotated[int, Field(ge=1, strict=True)]


class SegmentText(BaseModel):
    """One segment: duration, speed of one shaft, and load as a torque (in a line, a force) or by occupancy."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    duration: Annotated[float, Parameter("s", "length of the segment", above=0)]
    output_speed: Annotated[float, Parameter("rad/s", "output speed")] | None = None
    motor_speed: Annotated[float, Parameter("rad/s", "motor speed", turns=True)] | None = None
    ramp: StrictBool = False
    load_torque: Annotated[float, Parameter("N*m", "mean load at the wear part", low=0)] | None = None
    occupancy: Percent | None = None

    @model_validator(mode="after")
    def _one_of_each(self) -> SegmentText:
        if (self.output_speed is None) == (self.motor_speed is None):
            raise ValueError("a segment needs its speed, once; write output_speed or motor_speed, 0 rpm for a rest")
        if self.load_torque is not None and self.occupancy is not None:
            raise ValueError("both load_torque and occupancy are stated; keep one")
        return self


class DutyCycleText(BaseModel):
    """Segments and their repeats; without ``repeats`` they fill the run."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    segments: tuple[SegmentText, ...] = Field(min_length=1)
    repeats: Repeats | None = None

    @field_validator("segments", mode="before")
    @classmethod
    def _none_missing(cls, written: Any) -> Any:
        if not isinstance(written, list) or not written:
            raise ValueError("a duty cycle needs a list of segments; write [{duration: 10 s, output_speed: 200 rpm}]")
        for number, one in enumerate(written, start=1):
            if not isinstance(one, dict | SegmentText):
                raise ValueError(
                    f"segment {number} is missing (it is {one!r}); write its duration and speed, or delete its line"
                )
        return written


class TableText(BaseModel):
    """A file with time_s and a speed, and its repeats."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    file: str
    repeats: Repeats = 1
