"""What other variables state about a variable: the headers of catman, and units in texts such as ``torque_unit``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from torquerig.recordings.files.matlab.leaves import HEADER, Leaf, is_time_name
from torquerig.recordings.files.matlab.stated_rate import rate_of
from torquerig.recordings.files.matlab.tree import Numbers

_OF_CHANNEL, _DATA = re.compile(rf"(Channel_\d+){HEADER}"), re.compile(r"(Channel_\d+)_Data")
_UNIT_ENDS = ("_unit", "_units", "_einheit")


def with_headers(leaves: Sequence[Leaf], *, where: str) -> list[Leaf]:
    """Return the leaves with the names, units and rates that other variables state.

    ``Channel_1_Header`` describes ``Channel_1_Data`` by ``SignalName``, ``Unit`` and ``SampleFrequency``;
    ``torque_unit`` is the unit of ``torque``.

    Raises
    ------
    RecordingError
        Where the sample frequency of a header has a unit that is not one of a rate.
    """
    headers: dict[str, dict[str, str | float]] = {}
    for leaf in leaves:
        found = _OF_CHANNEL.fullmatch(leaf.path[0])
        value = leaf.node.scalar() if isinstance(leaf.node, Numbers) else leaf.node
        if found and len(leaf.path) == 2 and isinstance(value, str | float):
            headers.setdefault(found[1], {})[leaf.path[1].lower()] = value
    named = {number: one for number, one in headers.items() if str(one.get("signalname", "")).strip()}
    described = [_described(leaf, named, where) for leaf in leaves if _number(leaf, _OF_CHANNEL) not in named]
    return _with_units(described)


def _number(leaf: Leaf, pattern: re.Pattern[str]) -> str:
    found = pattern.fullmatch(leaf.path[0])
    return found[1] if found else ""


def _described(leaf: Leaf, headers: dict[str, dict[str, str | float]], where: str) -> Leaf:
    """Return the data of a header with its name, unit and rate; another leaf as it is."""
    header = headers.get(_number(leaf, _DATA))
    if header is None or len(leaf.path) > 1:
        return leaf
    name, unit = (str(header.get(key, "")).strip() for key in ("signalname", "unit"))
    rate = rate_of({"sample_frequency": header.get("samplefrequency", "")}, where=f"{where}: {name}")
    is_time = is_time_name(name)
    return replace(leaf, path=(name,), unit=unit, is_time=is_time, rate=0.0 if is_time else rate)


def _with_units(leaves: Sequence[Leaf]) -> list[Leaf]:
    """Return the leaves with the units that texts of their name and ``_unit`` state."""
    units = {
        (*leaf.path[:-1], leaf.path[-1].lower().removesuffix(end)): leaf
        for leaf in leaves
        for end in _UNIT_ENDS
        if isinstance(leaf.node, str) and leaf.path[-1].lower().endswith(end)
    }
    found = {}
    for leaf in leaves:
        key = (*leaf.path[:-1], leaf.path[-1].lower())
        if isinstance(leaf.node, Numbers) and key in units:
            found[leaf.path] = units[key]
    used = {one.path for one in found.values()}
    return [
        replace(leaf, unit=leaf.unit or str(found[leaf.path].node).strip()) if leaf.path in found else leaf
        for leaf in leaves
        if leaf.path not in used
    ]
