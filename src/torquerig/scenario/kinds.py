"""The kinds of parts and effects that a scenario may name."""

from __future__ import annotations

from typing import get_args, get_type_hints

from torquerig import mechanisms
from torquerig.rig import parts
from torquerig.rig.assembly import Part

KINDS: dict[str, type[Part]] = {
    word: cls
    for cls in (*(getattr(parts, name) for name in parts.__all__), *mechanisms.extended().values())
    for word in get_args(get_type_hints(cls)["kind"])
}
"""Every kind of part and effect, by the word that a scenario uses."""
