"""The kinematics of a rig: poles, slots, ratio and teeth, from which its lines follow."""

from __future__ import annotations

from math import prod

from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor
from torquerig.rig.parts.gear_stage import GearStage


def kinematics_of(rig: Rig) -> Kinematics:
    """Return poles and slots of the rig's first motor, and ratio and teeth of the gears up to the measured part."""
    motor = next(iter(rig.parts_of(Motor)), None)
    gears = gears_to_sensor(rig)
    return Kinematics(
        pole_pairs=None if motor is None else motor.pole_pairs,
        slots=None if motor is None else motor.slots,
        ratio=turns_to(rig, rig.measured),
        teeth=tuple(stage for gear in gears for stage in gear.teeth),
    )


def gears_to_sensor(rig: Rig) -> tuple[GearStage, ...]:
    """Return the gears from the start of the shaft to the measured part; those of other branches do not count."""
    return gears_to(rig, rig.measured)


def gears_to(rig: Rig, last: str) -> tuple[GearStage, ...]:
    """Return the gears from the start of the shaft to the part called ``last``, which may be one of them."""
    gears: list[GearStage] = []
    name: str | None = last
    while name is not None:
        part = rig.part(name)
        gears += [part] if isinstance(part, GearStage) else []
        name = part.after
    return tuple(reversed(gears))


def turns_to(rig: Rig, last: str) -> float:
    """Return the turns of the motor per turn of the output of ``last`` [1], without sign."""
    return abs(prod(gear.ratio for gear in gears_to(rig, last)))


def torque_gain(rig: Rig) -> float:
    """Return the steady torque at the measured part per torque of the motor: the gears' ratios times efficiencies."""
    return prod(abs(gear.ratio) * gear.efficiency for gear in gears_to_sensor(rig))
