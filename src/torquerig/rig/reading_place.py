"""Where on the shafts a rig's reading is taken."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import ImposedMotion


def reading_place(rig: Rig) -> str:
    """Return the part where the reading is taken: the sensor itself, or what the measured motion is imposed on."""
    part = rig.part(rig.measured)
    return part.at if isinstance(part, ImposedMotion) else rig.measured
