"""Where the keys and values of a YAML text begin and end, by the marks of its nodes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import yaml

from torquerig.errors import InputError

Keys = tuple[str | int, ...]
"""The path of a value: names of mappings and places in lists."""


@dataclass(frozen=True)
class Entry:
    """One entry of a mapping or list; ``begin`` and ``end`` are places in the text [characters].

    ``begin`` is that of the key, or of the dash of a list in block form; ``end`` is behind the last sign of the value.
    """

    name: str | int
    begin: int
    end: int
    value: yaml.Node


def node_at(root: yaml.Node, keys: Sequence[str | int]) -> yaml.Node | None:
    """Return the node under a path; None where the text does not have it."""
    node = root
    for key in keys:
        found = _child(node, key)
        if found is None:
            return None
        node = found
    return node


def end_of(node: yaml.Node, text: str) -> int:
    """Return the place behind the last sign of a value, without the comments and empty lines that follow it."""
    if isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        return end_of(last[1] if isinstance(node, yaml.MappingNode) else last, text)
    begin, end = int(node.start_mark.index), int(node.end_mark.index)
    while end > begin and text[end - 1] in "\r\n ":  # behind a text of several lines (|, >)
        end -= 1
    return end


def entries_of(node: yaml.CollectionNode, text: str) -> tuple[Entry, ...]:
    """Return the entries of a mapping or list in their order.

    Raises
    ------
    InputError
        Where a value is an alias (``*name``): its text is in another place.
    """
    found: list[Entry] = []
    before = int(node.start_mark.index)
    for place, item in enumerate(node.value):
        name, value = (item[0].value, item[1]) if isinstance(node, yaml.MappingNode) else (place, item)
        begin = int((item[0] if isinstance(node, yaml.MappingNode) else item).start_mark.index)
        end = end_of(value, text)
        if begin < before or int(value.start_mark.index) < begin or end < begin:
            raise InputError(f"{name}: its value is shared with another key by an alias (*); edit the file as text")
        if not isinstance(node, yaml.MappingNode) and not node.flow_style:
            begin = text.rindex("-", before, begin)
        found.append(Entry(name, begin, end, value))
        before = end
    return tuple(found)


def line_start(text: str, place: int) -> int:
    """Return where the line of a place begins."""
    return text.rfind("\n", 0, place) + 1


def line_end(text: str, place: int) -> int:
    """Return where the line of a place ends, behind its line break; the end of the text where it has none."""
    found = text.find("\n", place)
    return len(text) if found < 0 else found + 1


def _child(node: yaml.Node, key: str | int) -> yaml.Node | None:
    if isinstance(node, yaml.MappingNode):
        return next((value for name, value in node.value if name.value == str(key)), None)
    if isinstance(node, yaml.SequenceNode) and isinstance(key, int) and 0 <= key < len(node.value):
        found: yaml.Node = node.value[key]
        return found
    return None
