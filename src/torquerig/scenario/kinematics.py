"""The kinematics of a rig: poles, slots, ratio and teeth, from which its lines follow."""

from __future__ import annotations

from math import prod

from torquerig.rig.parts import Gear, Motor
from torquerig.rig.rig import Rig
from torquerig.signals.kinematics import Kinematics


def kinematics_of(rig: Rig) -> Kinematics:
    """Return poles and slots of the rig's first motor, and ratio and teeth of the gears."""
    motor = next((part for part in rig.parts if isinstance(part, Motor)), None)
    gears = [part for part in rig.parts if isinstance(part, Gear)]
    return Kinematics(
        pole_pairs=None if motor is None else motor.pole_pairs,
        slots=None if motor is None else motor.slots,
        ratio=abs(prod(gear.ratio for gear in gears)),
        teeth=tuple(stage for gear in gears for stage in gear.teeth),
    )
