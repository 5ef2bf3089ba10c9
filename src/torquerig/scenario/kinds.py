"""The kinds of parts and effects that a scenario may name."""

from __future__ import annotations

from inspect import get_annotations
from typing import get_args, get_type_hints

from torquerig import mechanisms
from torquerig.rig import parts
from torquerig.rig.assembly import Part


def _words(cls: type[Part]) -> tuple[str, ...]:
    """Return the words for a class, from the annotation of its ``kind`` alone: those of all its fields take long."""
    owner = next(base for base in cls.__mro__ if "kind" in get_annotations(base))
    alone = {"__annotations__": {"kind": get_annotations(owner)["kind"]}, "__module__": owner.__module__}
    return get_args(get_type_hints(type(owner.__name__, (), alone))["kind"])


KINDS: dict[str, type[Part]] = {
    word: cls
    for cls in (*(getattr(parts, name) for name in parts.__all__), *mechanisms.extended().values())
    for word in _words(cls)
}
"""Every kind of part and effect, by the word that a scenario uses."""
