"""Where the parts of a scenario are drawn: along their shaft, effects below what they act on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from torquerig.rig.assembly import HOST_FIELDS, Part
from torquerig.scenario.kinds import KINDS


@dataclass(frozen=True, kw_only=True)
class PlacedPart:
    """A part of the file.

    Parameters
    ----------
    name, kind : str
    column, row : int
        Of its box on a shaft; -1 for what is not on a shaft.
    after : str
        The part whose shaft it continues; empty at the start of a shaft.
    host : str
        The part on a shaft that an effect acts on; empty where it has none.
    """

    name: str
    kind: str
    column: int = -1
    row: int = -1
    after: str = ""
    host: str = ""


def placed_parts(rig: Any) -> tuple[PlacedPart, ...]:
    """Return the parts of the mapping ``rig`` of a scenario, in its order; those that are no mapping have no kind."""
    if not isinstance(rig, Mapping):
        return ()
    places: dict[str, tuple[int, int]] = {}
    ends: dict[str, int] = {}
    found: list[PlacedPart] = []
    shaft, rows = "", 0
    for key, written in rig.items():
        name, part = str(key), written if isinstance(written, Mapping) else {}
        kind = KINDS.get(str(part.get("kind")), Part)
        if not kind.on_shaft:
            found.append(PlacedPart(name=name, kind=str(part.get("kind", "")), host=_host(part, kind)))
            continue
        stated = part.get("after", shaft)
        after = str(stated) if stated in places else ""
        column = places[after][0] + 1 if after else 0
        row = ends.pop(after) if after in ends and not kind.ends_shaft else rows
        rows = max(rows, row + 1)
        places[name], ends[name] = (column, row), row
        found.append(PlacedPart(name=name, kind=str(part["kind"]), column=column, row=row, after=after))
        shaft = shaft if kind.ends_shaft else name
    return tuple(found)


def _host(part: Mapping[str, Any], kind: type[Part]) -> str:
    """Return what an effect acts on: as stated, else as its kind has it by default."""
    stated = (part.get(field, getattr(kind, field, None)) for field in HOST_FIELDS)
    return next((one for one in stated if isinstance(one, str)), "")
