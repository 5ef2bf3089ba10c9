"""The part of a rig whose torque is measured."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion


def reading_place(rig: Rig) -> str:
    """Return the part whose torque is measured: the sensor, or the part with an imposed motion."""
    part = rig.part(rig.measured)
    return part.at if isinstance(part, ImposedMotion) else rig.measured
