"""Values as YAML text that reads back as the same value."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import isfinite
from pathlib import Path
from typing import Any

import yaml

from torquerig.errors import InputError
from torquerig.safe_yaml import read_yaml

WIDEST = 100  # [characters] a longer mapping is written in block form, one key per line
_ANY = Path("value")


def value_from_text(text: str) -> Any:
    """Return the value of what a person wrote into a field: a number, a text with unit, a list, a mapping.

    An empty text is None.

    Raises
    ------
    InputError
        Where the text is no YAML value.
    """
    if not text.strip():
        return None
    try:
        items = read_yaml(f"[\n{text}\n]", _ANY)[0]
    except InputError:
        return _after_key(text)
    return items[0] if len(items) == 1 else _after_key(text)


def flow_text(value: Any) -> str:
    """Return a value in flow form, on one line: ``{kind: body, inertia: 2e-3 kg*m^2}``.

    Raises
    ------
    InputError
        For a number that is not finite, and for a value of a kind that no YAML file of torquerig holds.
    """
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_scalar(key)}: {flow_text(one)}" for key, one in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(flow_text(one) for one in value) + "]"
    return _scalar(value)


def entry_text(key: str | int, value: Any, *, indent: int, newline: str = "\n") -> str:
    """Return ``key: value`` in flow form, or in block form where that is longer than a line.

    Parameters
    ----------
    indent : int
        Spaces before the key; the first line has none, because it is put behind them.
    """
    line = f"{_scalar(key)}: {flow_text(value)}"
    if not isinstance(value, Mapping) or not value or len(line) + indent <= WIDEST:
        return line
    inner = " " * (indent + 2)
    below = [inner + entry_text(name, one, indent=indent + 2, newline=newline) for name, one in value.items()]
    return newline.join([f"{_scalar(key)}:", *below])


def _after_key(text: str) -> Any:
    """Return a text that is a value only outside of brackets, such as ``a, b``, as read behind a key."""
    try:
        data = read_yaml(f"value: {text.strip()}", _ANY)[0]
    except InputError:
        raise InputError(f"{text.strip()!r} is no value; close every bracket and quote") from None
    return data["value"] if set(data) == {"value"} else text


def _scalar(value: Any) -> str:
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        if not isfinite(value):
            raise InputError(f"{value} is not finite; write a number")
        return repr(value)
    if isinstance(value, str):
        return value if _reads_back(value) else json.dumps(value, ensure_ascii=False)
    raise InputError(f"a value of the type {type(value).__name__} cannot be written; write a number, text, list or "
                     "mapping")  # fmt: skip


def _reads_back(text: str) -> bool:
    """Whether a text without quotes is read as that text, within brackets and as a key."""
    if not text or text != text.strip() or len(text.splitlines()) != 1:
        return False
    try:
        data = read_yaml(f"[{{{text}: {text}}}]", _ANY)[0]
    except (InputError, yaml.YAMLError):
        return False
    return bool(data == [{text: text}])
