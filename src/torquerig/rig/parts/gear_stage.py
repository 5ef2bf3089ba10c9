"""What counts as a stage between two speeds: gears and belts, the parts that effects of a gear may live in."""

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
    """Return the gear or belt ``name``; InputError, said of the effect ``owner``, where it is none."""
    part = rig.part(name)
    if not isinstance(part, GearStage):
        raise InputError(f"{owner}: gear: {name!r} is no gear; name one")
    return part
