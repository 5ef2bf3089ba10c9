"""What-if without editing: ``gearbox.ratio=10`` put into a scenario's data before it is read."""

from __future__ import annotations

import copy
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from torquerig.document import Document, parse_document
from torquerig.errors import InputError, did_you_mean


def overridden(document: Document, settings: Sequence[str]) -> Document:
    """Return the document with each ``path=value`` of ``settings`` put in; the value is read as YAML.

    A path is the end of a dotted path that stands in the scenario once: ``load.occupancy`` finds
    ``operating_point.load.occupancy``. A key that its mapping does not state yet may be set where the mapping is found.
    """
    data = copy.deepcopy(document.data)
    for setting in settings:
        path, equals, text = setting.partition("=")
        if not equals or not path.strip() or not text.strip():
            raise InputError(f"--set {setting}: not of the form path=value; write for example --set gearbox.ratio=10")
        value = parse_document(text.strip(), Path(f"--set {setting}")).data
        holder, key = _find(data, path.strip().split("."), setting)
        holder[key] = value
    return Document(document.path, data, document.node)


def _find(data: Any, path: list[str], setting: str) -> tuple[dict[str, Any], Any]:
    exact = [hit for hit in _mappings(data) if _ends_with((*hit[0], hit[2]), path)]
    hits = exact or [
        (where, holder[path[-2]], path[-1])
        for where, holder, key in _mappings(data)
        if len(path) > 1 and _ends_with((*where, key), path[:-1]) and isinstance(holder[key], dict)
    ]
    if len(hits) > 1:
        written = " and ".join(".".join(map(str, (*where, key))) for where, _, key in hits)
        raise InputError(f"--set {setting}: this could be {written}; write more of the path")
    if not hits:
        known = {".".join(map(str, (*where[-1:], key))) for where, _, key in _mappings(data)}
        raise InputError(f"--set {setting}: the scenario has no such path; {did_you_mean('.'.join(path), known)}")
    return hits[0][1], hits[0][2]


def _mappings(data: Any, where: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], dict[Any, Any], Any]]:
    """Yield (path of the mapping, the mapping, key) for every key of every mapping."""
    if isinstance(data, dict):
        for key, value in data.items():
            yield where, data, key
            yield from _mappings(value, (*where, key))


def _ends_with(where: tuple[Any, ...], path: list[str]) -> bool:
    return len(where) >= len(path) and [str(key) for key in where[-len(path) :]] == path
