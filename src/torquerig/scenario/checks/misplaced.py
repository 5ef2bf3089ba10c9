"""The right place of a key that a scenario states in the wrong one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields
from typing import Any, get_args

from pydantic import BaseModel

from torquerig.scenario.conditions.operating_point import OperatingPoint
from torquerig.scenario.conditions.recording_settings import RecordingSettings
from torquerig.scenario.kinds import KINDS

_TOP = ("scenario", "operating_point", "recording", "measured", "rig", "study")
_OF_EVERY_PART = ("name", "kind", "group")


def place_of(key: str, written: Any, data: Mapping[str, Any], *, here: str) -> str | None:
    """Return where an unknown key would be right, as a remedy; None where it is right nowhere.

    Parameters
    ----------
    key, written
        The key and its value.
    data : mapping
        The whole scenario.
    here : str
        Dotted path of the mapping that has the key.
    """
    if isinstance(written, Mapping) and written.get("kind") in [*KINDS]:
        return f"a {written['kind']} is part of the rig; move it to rig.{key}" if here != "rig" else None
    if key in _TOP and here != "the top level":
        return f"{key}: is a section of its own; move it to the top level of the file"
    places = [path for section, model in _sections_as_models() for path in _paths(key, model, section)]
    places += [f"rig.{name}.{key}" for name, part in _parts(data) if key in _fields_of(part.get("kind"))]
    places = sorted((one for one in places if one.rpartition(".")[0] != here), key=lambda one: not one.startswith(here))
    if places:
        return f"it has no meaning in {here}; move it to {' or '.join(places[:3])}"
    kinds = [kind for kind in KINDS if key in _fields_of(kind)]
    return f"it has no meaning in {here}; only a part of kind {' or '.join(kinds[:3])} has it" if kinds else None


def _sections_as_models() -> tuple[tuple[str, type[BaseModel]], ...]:
    from torquerig.scenario.study_section import Settings  # only a file that has a study, or a fault, needs it

    return ("operating_point", OperatingPoint), ("recording", RecordingSettings), ("study", Settings)


def _paths(key: str, model: type[BaseModel], path: str) -> Iterator[str]:
    """Yield the dotted paths at which a model, or one inside it, has the key."""
    for name, field in model.model_fields.items():
        if name == key:
            yield f"{path}.{name}"
        for inner, entry in _models_in(field.annotation):
            yield from _paths(key, inner, f"{path}.{name}{entry}")


def _models_in(annotation: Any, entry: str = "") -> Iterator[tuple[type[BaseModel], str]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation, entry
    within = ".NAME" if getattr(annotation, "__origin__", None) is dict else entry
    for inner in get_args(annotation):
        yield from _models_in(inner, within)


def _parts(data: Mapping[str, Any]) -> Iterator[tuple[str, Mapping[str, Any]]]:
    rig = data.get("rig")
    for name, part in rig.items() if isinstance(rig, Mapping) else ():
        if isinstance(part, Mapping):
            yield str(name), part


def _fields_of(kind: Any) -> set[str]:
    cls = KINDS.get(kind) if isinstance(kind, str) else None
    return set() if cls is None else {field.name for field in fields(cls)} - {*_OF_EVERY_PART}
