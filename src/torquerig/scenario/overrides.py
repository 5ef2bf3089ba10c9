"""Settings such as ``gearbox.ratio=10`` that replace values of a scenario before it is read."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.document import Document, parse_document
from torquerig.errors import InputError, TorquerigError, did_you_mean
from torquerig.scenario.section_names import SECTIONS


@dataclass(frozen=True)
class EditedDocument(Document):
    """A document with values of an option in it: ``edits`` are (path in the data, setting), the last one counts."""

    edits: tuple[tuple[tuple[str, ...], str], ...] = ()
    option: str = "--set"

    def place(self, keys: Iterable[str | int] = ()) -> str:
        """Return ``OPTION path=value: a.b`` for what a setting put in, else file and line as for any document."""
        keys = tuple(keys)
        path = tuple(str(key) for key in keys)
        for edited, setting in reversed(self.edits):
            if path[: len(edited)] == edited or edited == (*path, "value"):
                return f"{self.option} {setting}: {'.'.join(path)}"
        return super().place(keys)


def naming_edits(document: Document, error: TorquerigError) -> TorquerigError:
    """Return the error with the document's settings named, where its place alone would be misleading."""
    if not isinstance(document, EditedDocument) or f"{document.option} " in str(error):
        return error
    written = " ".join(f"{document.option} {setting!r}" for _, setting in document.edits)
    return type(error)(f"{error} (the scenario was read with {written})")


def overridden(document: Document, settings: Sequence[str], *, option: str = "--set") -> Document:
    """Return the document with each ``path=value`` of ``settings`` put in; the value is read as YAML.

    A path is the end of a dotted path that occurs in the scenario once: ``load.occupancy`` finds
    ``operating_point.load.occupancy``. A key that its mapping does not state yet may be set where the mapping is found.
    ``option`` is where the settings were written, for errors.
    """
    if not settings:
        return document
    data = copy.deepcopy(document.data)
    edits = []
    for setting in settings:
        path, equals, text = setting.partition("=")
        if not equals or not path.strip() or not text.strip():
            raise InputError(
                f"{option} {setting}: not of the form path=value; write for example {option} gearbox.ratio=10"
            )
        where, holder, key = _find(data, path.strip().split("."), f"{option} {setting}")
        holder[key] = _value(text.strip(), f"{option} {setting}")
        edits.append(((*(str(part) for part in where), str(key)), setting))
    return EditedDocument(document.path, data, document.node, tuple(edits), option)


def _value(text: str, written: str) -> Any:
    try:
        return parse_document(text, Path("value")).data
    except InputError:
        raise InputError(
            f"{written}: {text!r} is no YAML value; close every bracket and quote, "
            "for example 'rig.gap={kind: backlash, gap: 4 arcmin}'"
        ) from None


def _find(data: Any, path: list[str], written: str) -> tuple[tuple[Any, ...], dict[Any, Any], Any]:
    """Return (path of the mapping, the mapping, key) that a setting means."""
    exact = [hit for hit in _mappings(data) if _ends_with((*hit[0], hit[2]), path)]
    hits = exact or [
        ((*where, key), holder[key], path[-1])
        for where, holder, key in _mappings(data)
        if len(path) > 1 and _ends_with((*where, key), path[:-1]) and isinstance(holder[key], dict)
    ]
    if len(hits) > 1:
        places = " and ".join(".".join(map(str, (*where, key))) for where, _, key in hits)
        known = {str(key) for _, _, key in _mappings(data)}
        close = did_you_mean(path[-1], known) if path[-1] not in known else ""
        remedy = close if close.startswith("did you mean") else "write more of the path"
        raise InputError(f"{written}: this could be {places}; {remedy}")
    if not hits:
        _refuse_in_missing_section(data, path, written)
        known = {".".join(map(str, (*where[-1:], key))) for where, _, key in _mappings(data)}
        raise InputError(f"{written}: the scenario has no such path; {did_you_mean('.'.join(path), known)}")
    return hits[0]


def _refuse_in_missing_section(data: Any, path: list[str], written: str) -> None:
    """Raise InputError where the path starts with a section that a scenario may have and this one has not."""
    section = path[0]
    if len(path) > 1 and section in SECTIONS and isinstance(data, dict) and section not in data:
        raise InputError(
            f"{written}: the scenario has no section {section}:, so that nothing of it can be set; write the "
            "section first, or use a scenario that has it"
        )


def _mappings(data: Any, where: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], dict[Any, Any], Any]]:
    """Yield (path of the mapping, the mapping, key) for every key of every mapping."""
    if isinstance(data, dict):
        for key, value in data.items():
            yield where, data, key
            yield from _mappings(value, (*where, key))


def _ends_with(where: tuple[Any, ...], path: list[str]) -> bool:
    return len(where) >= len(path) and [str(key) for key in where[-len(path) :]] == path
