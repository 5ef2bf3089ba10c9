"""The operating point of a scenario: speed, profile, occupancy, particle size."""

from __future__ import annotations

from math import isclose
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, model_validator

from torquerig.errors import InputError, UnitError
from torquerig.parameter import Parameter
from torquerig.rig.parts import Motor, SpeedController
from torquerig.rig.rig import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.signals.run import Profile, Run
from torquerig.units import parse_quantity


def _percent(written: Any) -> float:
    """Return an occupancy in percent: ``21`` and ``"21 %"`` are 21."""
    if isinstance(written, bool) or not isinstance(written, int | float | str):
        raise ValueError(f"{written!r} is no occupancy; write for example 21 %")
    try:
        percent = float(written) if isinstance(written, int | float) else 100 * parse_quantity(written, "1")
    except UnitError as error:
        raise ValueError(str(error)) from None
    if isinstance(written, str) and "%" not in written:
        raise ValueError(f"{written!r} has no unit; write '{written} %'")
    if not 0 <= percent <= 100:
        raise ValueError(f"{percent:g} % is no occupancy; it lies between 0 and 100 %")
    return percent


Percent = Annotated[float, BeforeValidator(_percent)]


class Load(BaseModel):
    """What the wear part works in."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    occupancy: Percent = 0.0
    particle_size: Annotated[float, Parameter("m", "particle size", above=0)] = 0.5e-3


class OperatingPoint(BaseModel):
    """Set-points of a study. One of the two speeds; the other follows from the gears."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    motor_speed: Annotated[float, Parameter("rad/s", "motor speed", low=0)] | None = None
    output_speed: Annotated[float, Parameter("rad/s", "output speed", low=0)] | None = None
    profile: Profile = "steady"
    load: Load = Load()
    speed_set_point_error_max: Annotated[float, Parameter("1", "largest error of the set-point", low=0)] = 0.0
    slow_speed_wander: Annotated[float, Parameter("1", "relative rms of the slow wander", low=0)] = 0.0

    @model_validator(mode="after")
    def _one_speed(self) -> OperatingPoint:
        if self.motor_speed is not None and self.output_speed is not None:
            raise ValueError("both motor_speed and output_speed are stated; keep one, the gears give the other")
        return self


def run_at(point: OperatingPoint, rig: Rig) -> Run:
    """Return the test sheet of the operating point on this rig."""
    motor = next(iter(rig.parts_of(Motor)), None)
    drive = next(iter(rig.parts_of(SpeedController)), None)
    if motor is None or drive is None:
        return Run(profile=point.profile, occupancy_percent=point.load.occupancy,
                   particle_size=point.load.particle_size)  # fmt: skip
    ratios = rig.speed_ratios(rig.node(drive.motor))
    if rig.node(rig.measured) not in ratios:
        raise InputError(
            f"no shaft leads from {drive.motor!r} to {rig.measured!r}, which is measured; link them with after:"
        )
    turned = abs(ratios[rig.node(rig.measured)])
    speed = point.motor_speed if point.output_speed is None else point.output_speed / turned
    stated = kinematics_of(rig).ratio  # 12.5 where 1 / turned is 12.500000000000002
    ratio = stated if isclose(1 / turned, stated, rel_tol=1e-9) else 1 / turned
    winding = {"pole_pairs": motor.pole_pairs, "slots": motor.slots}  # drawn ones are known to nobody else
    return Run(motor=motor.model or motor.name, gear_ratio=float(ratio), speed=speed, profile=point.profile,
               occupancy_percent=point.load.occupancy, particle_size=point.load.particle_size,
               others={key: count for key, count in winding.items() if count is not None})  # fmt: skip
