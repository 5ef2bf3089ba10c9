"""The kinematics of a rig: poles, slots, ratio and teeth, from which its lines follow."""

from __future__ import annotations

from math import prod

from torquerig.rig.parts import Motor
from torquerig.rig.parts.gear_stage import GearStage
from torquerig.rig.rig import Rig
from torquerig.signals.kinematics import Kinematics


def kinematics_of(rig: Rig) -> Kinematics:
    """Return poles and slots of the rig's first motor, and ratio and teeth of the gears up to the measured part."""
    motor = next(iter(rig.parts_of(Motor)), None)
    gears = gears_to_sensor(rig)
    return Kinematics(
        pole_pairs=None if motor is None else motor.pole_pairs,
        slots=None if motor is None else motor.slots,
        ratio=abs(prod(gear.ratio for gear in gears)),
        teeth=tuple(stage for gear in gears for stage in gear.teeth),
    )


def gears_to_sensor(rig: Rig) -> tuple[GearStage, ...]:
    """Return the gears from the start of the shaft to the measured part; those of other branches do not count."""
    gears: list[GearStage] = []
    name: str | None = rig.measured
    while name is not None:
        part = rig.part(name)
        gears += [part] if isinstance(part, GearStage) else []
        name = part.after
    return tuple(reversed(gears))


def torque_gain(rig: Rig) -> float:
    """Return the steady torque at the measured part per torque of the motor: the gears' ratios times efficiencies."""
    return prod(abs(gear.ratio) * gear.efficiency for gear in gears_to_sensor(rig))
