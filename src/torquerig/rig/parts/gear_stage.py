"""Stages between two speeds: gears and belts, the possible hosts of gear effects."""

from __future__ import annotations

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.gear import Gear

GearStage = Gear | BeltStage


def gear_stages(rig: Rig) -> tuple[GearStage, ...]:
    """Return all gears and belts of the rig, those behind the sensor and on branches included."""
    return tuple(part for part in rig.parts if isinstance(part, GearStage))


def gear_stage(rig: Rig, name: str, *, owner: str) -> GearStage:
    """Return the gear or belt ``name``; InputError, naming the effect ``owner``, where it is none."""
    part = rig.part(name)
    if not isinstance(part, GearStage):
        raise InputError(f"{owner}: gear: {name!r} is no gear; name one")
    return part
