"""The operating point of a scenario: speed, profile, occupancy, particle size."""

from __future__ import annotations

from dataclasses import replace
from math import isclose, pi
from pathlib import Path
from typing import Annotated, TypedDict

from pydantic import BaseModel, ConfigDict, model_validator

from torquerig.errors import InputError
from torquerig.parameter import Parameter
from torquerig.recordings.run import WANDER_CUTOFF, Profile, Run
from torquerig.rig.assembly import Rig
from torquerig.rig.leading_part import leading_motor, leading_part
from torquerig.rig.reading_place import reading_place
from torquerig.scenario.conditions.planned import planned
from torquerig.scenario.conditions.profile_text import DutyCycleText, TableText
from torquerig.scenario.kinematics import kinematics_of, stages_to
from torquerig.scenario.numbers.percent import Percent


class Load(BaseModel):
    """The load of the wear part."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    occupancy: Percent = 0.0
    particle_size: Annotated[float, Parameter("m", "particle size", above=0)] = 0.5e-3


class OperatingPoint(BaseModel):
    """Set-points of a study. One of the two speeds; the other follows from the gears.

    Each speed has the sign of the shaft that it is of: behind a stage that reverses the direction a positive
    ``output_speed`` turns the motor backwards. Where what is measured moves in a line, ``output_speed`` is its
    velocity.

    The profiles ``duty_cycle`` and ``csv`` bring their own speeds, which replace the stated one; their data is
    under the key of the same name, and may be there while another profile is selected.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    motor_speed: (
        Annotated[float, Parameter("rad/s", "motor speed; negative: the other direction", turns=True)] | None
    ) = None
    output_speed: Annotated[float, Parameter("rad/s", "output speed; negative: the other direction")] | None = None
    profile: Profile = "steady"
    duty_cycle: DutyCycleText | None = None
    csv: TableText | None = None
    load: Load = Load()
    speed_set_point_error_max: Annotated[float, Parameter("1", "largest error of the set-point", low=0)] = 0.0
    temperature_change: (
        Annotated[float, Parameter("K", "largest change of the sensor's temperature after its zero", low=0)] | None
    ) = None
    slow_speed_wander: Annotated[float, Parameter("1", "relative rms of the slow wander", low=0)] = 0.0
    slow_speed_wander_cutoff: Annotated[float, Parameter("Hz", "bandwidth of the slow wander", above=0)] = WANDER_CUTOFF

    @model_validator(mode="after")
    def _one_speed(self) -> OperatingPoint:
        if self.motor_speed is not None and self.output_speed is not None:
            raise ValueError("both motor_speed and output_speed are stated; keep one, the gears give the other")
        return self

    @model_validator(mode="after")
    def _has_its_points(self) -> OperatingPoint:
        if self.profile == "duty_cycle" and self.duty_cycle is None:
            raise ValueError("the profile duty_cycle needs its segments; add duty_cycle: {segments: [...]}")
        if self.profile == "csv" and self.csv is None:
            raise ValueError("the profile csv needs its table; add csv: {file: NAME.csv}")
        return self


def run_at(point: OperatingPoint, rig: Rig, *, folder: Path = Path()) -> Run:
    """Return the conditions of the run on this rig; the file of a profile's table is relative to ``folder``."""
    return replace(_run_at(point, rig, folder), wander_cutoff=point.slow_speed_wander_cutoff)


def _run_at(point: OperatingPoint, rig: Rig, folder: Path) -> Run:
    motor = leading_motor(rig)
    leader = leading_part(rig)
    if leader is None:
        return Run(profile=point.profile, speed=point.motor_speed, **_load_at(point, rig))
    ratios = rig.speed_ratios(rig.node(leader))
    read = rig.node(reading_place(rig))
    if read not in ratios:
        raise InputError(
            f"no shaft leads from {leader!r} to {rig.measured!r}, which is measured; link them with after:"
        )
    turned = ratios[read]
    speed = point.motor_speed if point.output_speed is None else point.output_speed / turned
    stated, turns = kinematics_of(rig).ratio, abs(1 / turned)  # 12.5 where turns is 12.500000000000002
    moved_in_a_line = rig.in_a_line(rig.part(reading_place(rig)))
    ratio = stated if moved_in_a_line or isclose(turns, stated, rel_tol=1e-9) else turns
    winding = (
        {"pole_pairs": motor.pole_pairs, "slots": motor.slots} if motor else {}
    )  # sampled ones are stated nowhere else
    # of a moved part without a gear behind it nobody states a ratio
    geared = motor is not None or bool(stages_to(rig, reading_place(rig)))
    travel = abs(2 * pi * turned * stated) if moved_in_a_line and stages_to(rig, reading_place(rig)) else None
    run = Run(motor=(motor.model or motor.name) if motor else None, gear_ratio=float(ratio) if geared else None,
              travel_per_turn=travel, speed=speed, **_load_at(point, rig),
              others={key: count for key, count in winding.items() if count is not None})  # fmt: skip
    points = point.duty_cycle if point.profile == "duty_cycle" else point.csv if point.profile == "csv" else None
    if points is None:
        return replace(run, profile=point.profile)
    course = planned(points, rig.at(run), motor_turns=1 / turned, folder=folder)
    return replace(run, profile=point.profile, set_points=course, speed=course.rows.top)


class _LoadOfRun(TypedDict, total=False):
    """The load of a run: occupancy [%] and particle size [m]."""

    occupancy_percent: float
    particle_size: float


def _load_at(point: OperatingPoint, rig: Rig) -> _LoadOfRun:
    """Return what the scenario states of the load; the defaults too, where a part of the rig depends on them."""
    stated = point.load.model_fields_set
    has_bed = any(hasattr(part, "mean_by_occupancy_percent") for part in rig.parts)
    made: _LoadOfRun = {}
    if has_bed or "occupancy" in stated:
        made["occupancy_percent"] = point.load.occupancy
    if has_bed or "particle_size" in stated:
        made["particle_size"] = point.load.particle_size
    return made
