"""Stages between two speeds: gears, belts, worms and linear drives, the possible hosts of gear effects."""

from __future__ import annotations

from torquerig.errors import InputError
from torquerig.rig.assembly import Rig
from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.gear import Gear
from torquerig.rig.parts.linear_drive import LinearDrive
from torquerig.rig.parts.worm_gear import WormGear

GearStage = Gear | BeltStage | WormGear | LinearDrive


def gear_stages(rig: Rig) -> tuple[GearStage, ...]:
    """Return all gears, belts, worms and linear drives of the rig, those of branches included."""
    return tuple(part for part in rig.parts if isinstance(part, GearStage))


def gear_stage(rig: Rig, name: str, *, owner: str) -> GearStage:
    """Return the gear, belt, worm or linear drive ``name``; InputError naming the effect ``owner`` where it is none."""
    part = rig.part(name)
    if not isinstance(part, GearStage):
        raise InputError(f"{owner}: gear: {name!r} is no gear; name one")
    return part
