"""One entry of a YAML text replaced, inserted, removed or moved, at the places that its nodes remember."""

from __future__ import annotations

import re
from typing import Any

import yaml

from torquerig.errors import InputError
from torquerig.studio.session.yaml_spans import Entry, Keys, end_of, entries_of, line_end, line_start, node_at
from torquerig.studio.session.yaml_values import entry_text, flow_text


def replaced_value(text: str, root: yaml.Node, keys: Keys, written: str) -> str:
    """Return the text with the value under ``keys`` replaced by ``written``, which is in flow form."""
    node = node_at(root, keys)
    if node is None:
        raise InputError(f"{'.'.join(map(str, keys))}: is not in the file")
    begin, end = int(node.start_mark.index), end_of(node, text)
    is_block = isinstance(node, yaml.CollectionNode) and not node.flow_style
    if keys and is_block and text[line_start(text, begin) : begin].strip() == "":  # below its key
        begin = _behind_key(text, root, keys)
    gap = "" if (begin and text[begin - 1] in " [{\n") or begin == 0 else " "
    return text[:begin] + gap + written + text[end:]


def inserted(text: str, root: yaml.Node, keys: Keys, place: int, *, name: str | int | None, value: Any) -> str:
    """Return the text with a new entry behind the entry ``place`` of a mapping or list; -1 is the beginning.

    ``name`` is the key, or None in a list.
    """
    node = _collection(root, keys)
    entries = entries_of(node, text)
    newline = "\r\n" if "\r\n" in text else "\n"
    if node.flow_style or not entries:
        return _inserted_in_flow(text, node, entries, place, name=name, value=value)
    first = entries[0].begin
    indent = first - line_start(text, first)
    new = f"- {flow_text(value)}" if name is None else entry_text(name, value, indent=indent, newline=newline)
    if place < 0:
        return text[:first] + new + newline + " " * indent + text[first:]
    at = line_end(text, entries[place].end)
    before = "" if text[:at].endswith("\n") else newline
    return text[:at] + before + " " * indent + new + newline + text[at:]


def without_entry(text: str, root: yaml.Node, keys: Keys, place: int) -> str:
    """Return the text without one entry; comments between the entries stay."""
    node = _collection(root, keys)
    entries = entries_of(node, text)
    one = entries[place]
    if len(entries) == 1:
        return replaced_value(text, root, keys, "{}" if isinstance(node, yaml.MappingNode) else "[]")
    if node.flow_style:
        return _removed_from_flow(text, entries, place)
    begin = line_start(text, one.begin)
    if text[begin : one.begin].strip() == "":
        return text[:begin] + text[line_end(text, one.end) :]
    following = entries[place + 1].begin  # it shares its line with what is before: - a: 1
    return text[: one.begin] + text[following:]


def moved_entry(text: str, root: yaml.Node, keys: Keys, place: int, onto: int) -> str:
    """Return the text with the entry ``place`` behind the entry ``onto`` (-1: first), with the comments above it."""
    node = _collection(root, keys)
    entries = entries_of(node, text)
    if node.flow_style or any(text[line_start(text, one.begin) : one.begin].strip() for one in entries):
        raise InputError(f"{'.'.join(map(str, keys))}: its entries share a line; move them in the text of the file")
    begin = _with_comments(text, entries, place)
    end = line_end(text, entries[place].end)
    block = text[begin:end]
    block += "" if block.endswith("\n") else "\n"
    at = _with_comments(text, entries, 0) if onto < 0 else line_end(text, entries[onto].end)
    head = "" if at == 0 or text[:at].endswith("\n") else "\n"
    if at <= begin:
        return text[:at] + head + block + text[at:begin] + text[end:]
    return text[:begin] + text[end:at] + head + block + text[at:]


def _collection(root: yaml.Node, keys: Keys) -> yaml.CollectionNode:
    node = node_at(root, keys)
    if not isinstance(node, yaml.CollectionNode):
        raise InputError(f"{'.'.join(map(str, keys))}: is no mapping and no list")
    return node


def _behind_key(text: str, root: yaml.Node, keys: Keys) -> int:
    """Return the place behind the colon of a key, or behind the dash of an item of a list."""
    holder = _collection(root, keys[:-1])
    if isinstance(holder, yaml.MappingNode):
        name = next(one for one, _ in holder.value if one.value == str(keys[-1]))
        return text.index(":", int(name.end_mark.index)) + 1
    return entries_of(holder, text)[int(keys[-1])].begin + 1


def _inserted_in_flow(
    text: str, node: yaml.CollectionNode, entries: tuple[Entry, ...], place: int, *, name: str | int | None, value: Any
) -> str:
    inner = flow_text([value])[1:-1] if name is None else flow_text({name: value})[1:-1]
    if not entries:
        begin, end = int(node.start_mark.index), int(node.end_mark.index)
        return text[:begin] + ("[" + inner + "]" if name is None else "{" + inner + "}") + text[end:]
    if place < 0:
        return text[: entries[0].begin] + inner + ", " + text[entries[0].begin :]
    at = entries[place].end
    return text[:at] + ", " + inner + text[at:]


def _removed_from_flow(text: str, entries: tuple[Entry, ...], place: int) -> str:
    one = entries[place]
    if place + 1 < len(entries):
        comma = re.compile(r"\s*,[ \t]*").match(text, one.end)
        return text[: one.begin] + text[comma.end() if comma else one.end :]
    comma_at = text.rindex(",", entries[place - 1].end, one.begin)
    between = text[comma_at + 1 : one.begin]
    return text[:comma_at] + (between if "#" in between else "") + text[one.end :]


def _with_comments(text: str, entries: tuple[Entry, ...], place: int) -> int:
    """Return where an entry begins, with the comment lines directly above it that are as far from the margin."""
    begin = line_start(text, entries[place].begin)
    indent = text[begin : entries[place].begin]
    floor = 0 if place == 0 else line_end(text, entries[place - 1].end)
    while begin > floor and text[line_start(text, begin - 1) : begin].startswith(f"{indent}#"):
        begin = line_start(text, begin - 1)
    return begin
