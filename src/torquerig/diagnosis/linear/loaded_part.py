"""Which part the load acts on."""

from __future__ import annotations

from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body


def loaded_part(rig: Rig) -> str | None:
    """Return the name of the part that a load states as its place, else of the last body, else None."""
    for part in rig.parts:
        at = getattr(part, "at", None)
        if part.group == "load" and isinstance(at, str):
            return at
    bodies = rig.parts_of(Body)
    return bodies[-1].name if bodies else None
