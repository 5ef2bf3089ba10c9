"""YAML files with line numbers; schema errors as one sentence each.

YAML here is YAML 1.2: ``no`` is text, ``0123`` is text, ``1e5`` is a number, and a duplicate key is an error.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import yaml

from torquerig.errors import InputError, did_you_mean
from torquerig.safe_yaml import LONGEST_TEXT, read_yaml
from torquerig.units.remedies import halved_between_terminals

if TYPE_CHECKING:
    from pydantic import TypeAdapter

Model = TypeVar("Model")
Renamed = Mapping[tuple[str, ...], str]
Elsewhere = Callable[[str, Any], str | None]
CLOSE = 0.8  # likeness of two names from which one is the other misspelt, as in difflib


@dataclass(frozen=True)
class Document:
    """A YAML file that has been read: its data, and the nodes that remember the lines."""

    path: Path
    data: Any
    node: yaml.Node

    def place(self, keys: Iterable[str | int] = ()) -> str:
        """Return ``file:line: a.b`` for the value under ``keys``; the parent's line where a key is missing."""
        node, found = self.node, []
        line = node.start_mark.line
        for key in keys:
            child = _child(node, key)
            if child is None:
                continue  # a missing key, or a tag that pydantic put into the path
            line, node = child
            found.append(str(key))
        dotted = ".".join(found)
        return f"{self.path}:{line + 1}: {dotted}" if dotted else f"{self.path}:{line + 1}"


def read_document(path: Path) -> Document:
    """Read one YAML file; InputError where it is missing, no YAML, empty, or beyond the limits of ``safe_yaml``."""
    try:
        with path.open("rb") as file:  # a device or pipe may have no end
            content = file.read(LONGEST_TEXT + 1)
        if len(content) > LONGEST_TEXT:
            raise InputError(f"{path}: has more than {LONGEST_TEXT / 1e6:g} MB, too much for a YAML file; is it a "
                             "recording or table?")  # fmt: skip
        text = content.decode("utf-8")
    except FileNotFoundError:
        near = [sibling.name for sibling in path.parent.glob("*.y*ml")] if path.parent.is_dir() else []
        hint = did_you_mean(path.name, near) if near else "check the path"
        raise InputError(f"{path}: there is no such file; {hint}") from None
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read ({error}); it must be a UTF-8 text file") from None
    return parse_document(text, path)


def parse_document(text: str, path: Path) -> Document:
    """Parse YAML text that came from ``path``; errors as in :func:`read_document`."""
    data, node = read_yaml(text, path)
    return Document(path, data, node)


def with_new_keys(document: Document, renamed: Renamed) -> Document:
    """Return the document with old names of keys replaced by the new ones; one notice on standard error lists them.

    Parameters
    ----------
    document : Document
    renamed : mapping of tuple of str to str
        The path of each old key, ``*`` for any key or list item on the way, and its new name.

    Raises
    ------
    InputError
        Where a mapping has a key under its old and its new name.
    """
    used: dict[str, str] = {}
    data = _new_data(document, document.data, keys=(), renamed=renamed, used=used)
    if not used:
        return document
    give_notice(str(document.path), used)
    return replace(document, data=data, node=_new_node(document.node, renamed))


def give_notice(where: str, used: Mapping[str, str]) -> None:
    """Write one line on standard error that lists old names with their new ones; nothing where none was used."""
    if used:
        listed = ", ".join(f"{old!r} is now {new!r}" for old, new in used.items())
        sys.stderr.write(f"{where}: old names, still read: {listed}\n")


def _inside(renamed: Renamed, key: str) -> dict[tuple[str, ...], str]:
    return {path[1:]: new for path, new in renamed.items() if len(path) > 1 and path[0] in ("*", key)}


def _new_data(
    document: Document, data: Any, *, keys: tuple[str | int, ...], renamed: Renamed, used: dict[str, str]
) -> Any:
    def below(value: Any, key: str | int) -> Any:
        return _new_data(document, value, keys=(*keys, key), renamed=_inside(renamed, str(key)), used=used)

    if isinstance(data, list):
        return [below(value, place) for place, value in enumerate(data)] if renamed else data
    if not isinstance(data, dict) or not renamed:
        return data
    held = {}
    for key, value in data.items():
        new = renamed.get((str(key),), key)
        if new != key:
            if new in data:
                raise InputError(f"{document.place((*keys, key))}: is the old name of {new!r}; keep one of them")
            used[str(key)] = str(new)
        held[new] = below(value, key)
    return held


def _new_node(node: yaml.Node, renamed: Renamed) -> yaml.Node:
    marks = (node.start_mark, node.end_mark)
    if isinstance(node, yaml.SequenceNode):
        return yaml.SequenceNode(node.tag, [_new_node(item, _inside(renamed, "*")) for item in node.value], *marks)
    if not isinstance(node, yaml.MappingNode):
        return node
    pairs = []
    for name, value in node.value:
        new = renamed.get((str(name.value),), name.value)
        key = name if new == name.value else yaml.ScalarNode(name.tag, new, name.start_mark, name.end_mark)
        pairs.append((key, _new_node(value, _inside(renamed, str(name.value)))))
    return yaml.MappingNode(node.tag, pairs, *marks)


def validated(
    document: Document, adapter: TypeAdapter[Model], *, within: tuple[str | int, ...] = (), data: Any = None,
    context: Mapping[str, Any] | None = None, elsewhere: Elsewhere | None = None,
) -> Model:  # fmt: skip
    """Return the document's data (or the part ``within``) as the adapter's type; InputError lists every problem.

    ``data`` replaces the part ``within`` where defaults have been filled in; places are those of the document.
    ``context`` is passed to the fields, such as ``{"in_a_line": True}``. ``elsewhere`` returns the remedy for an
    unknown key and its value where the key would be right in another place.
    """
    from pydantic import ValidationError

    if data is None:
        data = document.data
        for key in within:
            data = data[key]
    try:
        return adapter.validate_python(data, context=None if context is None else dict(context))
    except ValidationError as error:
        sentences = [
            _sentence(document, within, detail, adapter, elsewhere) for detail in _without_misspelt(error.errors())
        ]
        raise InputError("\n".join(dict.fromkeys(sentences))) from None


def _sentence(
    document: Document, within: tuple[str | int, ...], detail: Any, adapter: TypeAdapter[Any],
    elsewhere: Elsewhere | None,
) -> str:  # fmt: skip
    keys = (*within, *detail["loc"])
    kind, last = detail["type"], str(detail["loc"][-1]) if detail["loc"] else ""
    foreign = halved_between_terminals(last, detail.get("input")) if kind in UNKNOWN_KEYS else None
    if foreign:
        text = f"unknown key; {foreign}"
    elif kind == "misspelt":
        text = f"unknown key; did you mean {detail['meant']!r}?"
    elif kind in UNKNOWN_KEYS:
        known = _field_names(adapter, detail["loc"][:-1]) - {last}
        far = elsewhere is not None and not get_close_matches(last, known, n=1, cutoff=CLOSE)
        place = elsewhere(last, detail.get("input")) if far and elsewhere else None
        text = f"unknown key; {place or did_you_mean(last, known)}"
    elif kind in ("missing", "missing_argument"):
        text = f"the key {last!r} is missing; add it"
    elif kind == "value_error":
        text = str(detail["ctx"]["error"])
    else:
        text = problem_text(kind, detail)
    return f"{document.place(keys)}: {text}"


def problem_text(kind: str, detail: Any) -> str:
    """Return what is wrong with a value at a known key, and what to write."""
    written = detail.get("input")
    if kind in PLAIN_WORDS:
        return f"{written!r} is {PLAIN_WORDS[kind]}"
    if kind in BOUNDS:
        word, key = BOUNDS[kind]
        return f"{written!r} is out of range; it must be {word} {detail['ctx'][key]:g}"
    if kind in ("literal_error", "enum") and isinstance(written, str):
        return f"{written!r} is unknown; {did_you_mean(written, re.findall(QUOTED, detail['ctx']['expected']))}"
    shown = f" (it is {written!r})" if isinstance(written, str | int | float | bool) or written is None else ""
    return f"{detail['msg'][0].lower()}{detail['msg'][1:]}{shown}"


UNKNOWN_KEYS = ("extra_forbidden", "unexpected_keyword_argument")
PLAIN_WORDS: Mapping[str, str] = {
    **dict.fromkeys(("float_parsing", "float_type"), "no number; write one, such as 0.5"),
    **dict.fromkeys(("int_parsing", "int_type", "int_from_float"), "no whole number; write one, such as 3"),
    **dict.fromkeys(("dict_type", "model_type"), "no mapping; write key: value pairs"),
    **dict.fromkeys(("list_type", "tuple_type"), "no list; write [one, two]"),
}
"""Errors of pydantic as text with the remedy."""
BOUNDS: Mapping[str, tuple[str, str]] = {
    "greater_than_equal": ("at least", "ge"), "greater_than": ("above", "gt"),
    "less_than_equal": ("at most", "le"), "less_than": ("below", "lt"),
}  # fmt: skip
"""Bounds of pydantic: the word for each, and the key of its number."""
QUOTED = re.compile(r"'([^']*)'")


def _without_misspelt(details: Iterable[Any]) -> list[Any]:
    """Return the problems; an unknown key that misspells a missing one counts as one problem."""
    found = list(details)
    missing = [detail["loc"] for detail in found if detail["type"] in ("missing", "missing_argument")]
    for at, detail in enumerate(found):
        last = str(detail["loc"][-1]) if detail["loc"] else ""
        if detail["type"] not in UNKNOWN_KEYS or halved_between_terminals(last, detail.get("input")):
            continue
        siblings = {str(loc[-1]): loc for loc in missing if loc[:-1] == detail["loc"][:-1]}
        for meant in get_close_matches(str(detail["loc"][-1]), siblings, n=1, cutoff=CLOSE):
            found[at] = {"type": "misspelt", "loc": detail["loc"], "meant": meant}
            missing.remove(siblings[meant])
    return [
        detail for detail in found if detail["type"] not in ("missing", "missing_argument") or detail["loc"] in missing
    ]


def _field_names(adapter: TypeAdapter[Any], keys: Iterable[str | int]) -> set[str]:
    """Return the names of the fields that the mapping under ``keys`` may have."""
    definitions = {one["ref"]: one for one in _every_schema(adapter.core_schema) if "ref" in one}
    here = [*_unwrapped(adapter.core_schema, definitions)]
    for key in keys:  # a key that no schema has is a tag of pydantic
        here = [inner for schema in here for inner in _below(schema, key, definitions)] or here
    return {name for schema in here for name in _fields(schema)}


def _every_schema(schema: Any) -> Iterator[Mapping[str, Any]]:
    if isinstance(schema, Mapping):
        if "type" in schema:
            yield schema
        for value in schema.values():
            yield from _every_schema(value)
    elif isinstance(schema, list | tuple):
        for value in schema:
            yield from _every_schema(value)


def _unwrapped(schema: Any, definitions: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """Yield what a schema comes down to: without defaults, validators and models around it, each choice of a union."""
    if schema["type"] == "definition-ref":
        schema = definitions[schema["schema_ref"]]
    if schema["type"] in ("union", "tagged-union"):
        choices = schema["choices"]
        for choice in choices.values() if isinstance(choices, Mapping) else choices:
            yield from _unwrapped(choice[0] if isinstance(choice, tuple) else choice, definitions)
    elif "schema" in schema:
        yield from _unwrapped(schema["schema"], definitions)
    else:
        yield schema


def _fields(schema: Mapping[str, Any]) -> dict[str, Any]:
    fields = schema.get("fields", {})
    return dict(fields) if isinstance(fields, Mapping) else {field["name"]: field for field in fields}


def _below(schema: Mapping[str, Any], key: str | int, definitions: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    fields = _fields(schema)
    items = schema.get("items_schema")
    inner = [fields[str(key)]["schema"]] if str(key) in fields else []
    inner += [schema["values_schema"]] if "values_schema" in schema else []
    if isinstance(key, int) and items is not None:
        inner += items if isinstance(items, list) else [items]
    for one in inner:
        yield from _unwrapped(one, definitions)


def _child(node: yaml.Node, key: str | int) -> tuple[int, yaml.Node] | None:
    if isinstance(node, yaml.MappingNode):
        for name, value in node.value:
            if name.value == str(key):
                return name.start_mark.line, value
    if isinstance(node, yaml.SequenceNode) and isinstance(key, int) and key < len(node.value):
        item: yaml.Node = node.value[key]
        return item.start_mark.line, item
    return None
