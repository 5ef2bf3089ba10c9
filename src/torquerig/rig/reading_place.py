"""The part of a rig at which a measured place reads."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion, Probe, ReactionTorqueSensor
from torquerig.rig.point_sensor import PointSensor


def reading_place(rig: Rig, place: str | None = None) -> str:
    """Return the part at which ``place`` reads, by default ``measured``: the sensor, or the part that it reads."""
    name = rig.measured if place is None else place
    part = rig.part(name)
    if isinstance(part, ImposedMotion | Probe | PointSensor):
        return part.at
    return part.motor if isinstance(part, ReactionTorqueSensor) else name


def effort_unit(rig: Rig) -> str:
    """Return the unit of what is read at the measured place: N*m, or N where it moves in a line."""
    return "N" if rig.in_a_line(rig.part(reading_place(rig))) else "N*m"
