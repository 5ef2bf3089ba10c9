"""Edits of a YAML text by key path: the value changes, every other sign of the text stays.

Each function returns the new text. The text is read again before it is returned: it holds exactly the wanted data, or
the edit is refused with one sentence.
"""

from __future__ import annotations

import copy
from collections.abc import Mapping
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

import yaml

from torquerig.document import parse_document
from torquerig.errors import InputError, did_you_mean
from torquerig.studio.session.yaml_places import inserted, moved_entry, replaced_value, without_entry
from torquerig.studio.session.yaml_spans import Keys, node_at
from torquerig.studio.session.yaml_values import flow_text, value_from_text


def with_value(text: str, keys: Keys, value: Any, *, path: Path) -> str:
    """Return the text with the value under ``keys``; only what differs of mappings and lists is written.

    A key that its mapping does not have yet is added as the last one.

    Parameters
    ----------
    text : str
        A YAML file.
    keys : tuple of str or int
        Path of the value; a mapping on the way that is missing is made.
    value : scalar, list or mapping
    path : Path
        Of the file, for messages.

    Raises
    ------
    InputError
        Where the text is no YAML, the path leads through a value that is no mapping or list, or the file writes the
        place in a way that only a person can edit (an alias).
    """
    expected = _with(_data(text, path), keys, value, path)
    return _checked(_set(text, keys, value, path), expected, keys, path)


def with_text(text: str, keys: Keys, written: str, *, path: Path) -> str:
    """Return the text with a value as a person wrote it into a field, ``2.0e-4`` or ``200 rpm``; see `with_value`."""
    value = value_from_text(written)
    node = node_at(parse_document(text, path).node, keys)
    if isinstance(node, yaml.ScalarNode) and isinstance(value, int | float | str):
        expected = _with(_data(text, path), keys, value, path)
        as_written = replaced_value(text, parse_document(text, path).node, keys, written.strip())
        if _reads_as(as_written, expected, path):
            return as_written
    return with_value(text, keys, value, path=path)


def with_entry(text: str, keys: Keys, value: Any, *, after: str | None, path: Path) -> str:
    """Return the text with a new key behind the key ``after`` of its mapping; at the beginning where that is None.

    Raises
    ------
    InputError
        Where the key is there already, or ``after`` is not; else as :func:`with_value`.
    """
    data, holder = _data(text, path), keys[:-1]
    inside = _at(data, holder)
    if not isinstance(inside, dict):
        return with_value(text, keys, value, path=path)
    name = str(keys[-1])
    if name in inside:
        raise InputError(f"{_dotted(keys)}: is there already; choose another name")
    at = -1 if after is None else _place(inside, after, holder)
    rows = list(inside.items())
    rows.insert(at + 1, (name, value))
    expected = _with(data, holder, dict(rows), path)
    return _checked(
        inserted(text, parse_document(text, path).node, holder, at, name=name, value=value), expected, keys, path
    )


def without(text: str, keys: Keys, *, path: Path) -> str:
    """Return the text without a key or an item of a list; comments above it stay. Errors as :func:`with_value`."""
    data = _data(text, path)
    inside = _at(data, keys[:-1])
    if not keys or _at(data, keys) is _NOTHING:
        known = [str(key) for key in inside] if isinstance(inside, dict) else []
        raise InputError(f"{_dotted(keys)}: is not in the file; {did_you_mean(str(keys[-1]) if keys else '', known)}")
    expected = copy.deepcopy(data)
    del _at(expected, keys[:-1])[keys[-1]]
    place = list(inside).index(keys[-1]) if isinstance(inside, dict) else int(keys[-1])
    return _checked(without_entry(text, parse_document(text, path).node, keys[:-1], place), expected, keys, path)


def moved(text: str, keys: Keys, *, after: str | None, path: Path) -> str:
    """Return the text with a key behind the key ``after`` of the same mapping; its comments go with it.

    Raises
    ------
    InputError
        Where one of the two is not in the mapping; else as :func:`with_value`.
    """
    data, holder, name = _data(text, path), keys[:-1], str(keys[-1])
    inside = _at(data, holder)
    if not isinstance(inside, dict) or name not in inside:
        raise InputError(f"{_dotted(keys)}: is not in the file; choose a key that is there")
    if after == name:
        return text
    at, onto = list(inside).index(name), -1 if after is None else _place(inside, after, holder)
    order = [one for one in inside if one != name]
    order.insert(0 if after is None else order.index(after) + 1, name)
    expected = _with(data, holder, {one: inside[one] for one in order}, path)
    return _checked(moved_entry(text, parse_document(text, path).node, holder, at, onto), expected, keys, path)


class _Nothing:
    """What a path leads to that a file does not have."""


_NOTHING = _Nothing()


def _set(text: str, keys: Keys, value: Any, path: Path) -> str:
    """Return the text with a value put in by the smallest edits."""
    present = _at(_data(text, path), keys)
    if present is _NOTHING:
        return _added(text, keys, value, path)
    if type(present) is type(value) and present == value and _order(present) == _order(value):
        return text
    if isinstance(present, dict) and isinstance(value, Mapping) and value and present:
        return _set_mapping(text, keys, present, value, path)
    if isinstance(present, list) and isinstance(value, list) and value and present:
        return _set_list(text, keys, present, value, path)
    return replaced_value(text, parse_document(text, path).node, keys, flow_text(value))


def _added(text: str, keys: Keys, value: Any, path: Path) -> str:
    holder, name = keys[:-1], keys[-1]
    inside = _at(_data(text, path), holder)
    if not inside or inside is _NOTHING:
        return _set(text, holder, {name: value}, path)
    return inserted(text, parse_document(text, path).node, holder, len(inside) - 1, name=name, value=value)


def _set_mapping(text: str, keys: Keys, present: dict[Any, Any], value: Mapping[Any, Any], path: Path) -> str:
    shared = [key for key in present if key in value]
    if shared != [key for key in value if key in present] or not shared:
        return replaced_value(text, parse_document(text, path).node, keys, flow_text(value))
    for key in [key for key in present if key not in value]:
        places = list(_at(_data(text, path), keys))
        text = without_entry(text, parse_document(text, path).node, keys, places.index(key))
    for place, (key, one) in enumerate(value.items()):
        if key in present:
            text = _set(text, (*keys, key), one, path)
        else:
            text = inserted(text, parse_document(text, path).node, keys, place - 1, name=key, value=one)
    return text


def _set_list(text: str, keys: Keys, present: list[Any], value: list[Any], path: Path) -> str:
    if len(present) == len(value):
        for place, one in enumerate(value):
            text = _set(text, (*keys, place), one, path)
        return text
    steps = SequenceMatcher(a=[repr(one) for one in present], b=[repr(one) for one in value], autojunk=False)
    if steps.ratio() == 0.0:
        return replaced_value(text, parse_document(text, path).node, keys, flow_text(value))
    for kind, first, last, begin, end in reversed(steps.get_opcodes()):
        if kind == "equal":
            continue
        for one in reversed(value[begin:end]):
            text = inserted(text, parse_document(text, path).node, keys, last - 1, name=None, value=one)
        for place in reversed(range(first, last)):
            text = without_entry(text, parse_document(text, path).node, keys, place)
    return text


def _data(text: str, path: Path) -> Any:
    return parse_document(text, path).data


def _at(data: Any, keys: Keys) -> Any:
    for key in keys:
        if isinstance(data, dict):
            name = next((one for one in data if str(one) == str(key)), _NOTHING)
            data = _NOTHING if name is _NOTHING else data[name]
        elif isinstance(data, list) and isinstance(key, int) and 0 <= key < len(data):
            data = data[key]
        else:
            return _NOTHING
    return data


def _with(data: Any, keys: Keys, value: Any, path: Path) -> Any:
    """Return a copy of the data with a value under a path; InputError where the path cannot be."""
    if not keys:
        return copy.deepcopy(value)
    key, rest = keys[0], keys[1:]
    if data is None or data is _NOTHING:
        data = {}
    if isinstance(data, list) and isinstance(key, int) and 0 <= key < len(data):
        return [_with(one, rest, value, path) if place == key else one for place, one in enumerate(data)]
    if not isinstance(data, dict):
        raise InputError(f"{path}: {key} cannot be set, because what holds it is no mapping: {data!r}")
    held = dict(data)
    name = next((one for one in held if str(one) == str(key)), key)
    held[name] = _with(held.get(name), rest, value, path)
    return held


def _place(inside: Mapping[Any, Any], name: str, keys: Keys) -> int:
    names = [str(one) for one in inside]
    if name not in names:
        raise InputError(f"{_dotted(keys)}: has no {name!r}; {did_you_mean(name, names)}")
    return names.index(name)


def _order(data: Any) -> Any:
    """Return the data with the order of its keys, which two equal mappings may not share."""
    if isinstance(data, Mapping):
        return [(str(key), _order(one)) for key, one in data.items()]
    return [_order(one) for one in data] if isinstance(data, list) else data


def _reads_as(text: str, expected: Any, path: Path) -> bool:
    try:
        found = parse_document(text, path).data
    except InputError:
        return False
    return bool(found == expected and _order(found) == _order(expected))


def _checked(text: str, expected: Any, keys: Keys, path: Path) -> str:
    """Return the text where it holds the expected data; else refuse the edit."""
    if _reads_as(text, expected, path):
        return text
    raise InputError(f"{path}: {_dotted(keys)} cannot be edited here, because the file shares its value with another "
                     "key (& and *) or writes it in an unusual way; edit the file as text")  # fmt: skip


def _dotted(keys: Keys) -> str:
    return ".".join(map(str, keys))
