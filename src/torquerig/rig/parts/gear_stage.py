"""Stages between two speeds: gears, belts and worms, the possible hosts of gear effects."""

from __future__ import annotations

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.gear import Gear
from torquerig.rig.parts.worm_gear import WormGear

GearStage = Gear | BeltStage | WormGear


def gear_stages(rig: Rig) -> tuple[GearStage, ...]:
    """Return all gears, belts and worms of the rig, those behind the sensor and on branches included."""
    return tuple(part for part in rig.parts if isinstance(part, GearStage))


def gear_stage(rig: Rig, name: str, *, owner: str) -> GearStage:
    """Return the gear, belt or worm ``name``; InputError, naming the effect ``owner``, where it is none."""
    part = rig.part(name)
    if not isinstance(part, GearStage):
        raise InputError(f"{owner}: gear: {name!r} is no gear; name one")
    return part
