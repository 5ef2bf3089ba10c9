"""Parsing of YAML text within limits: no text makes the parser hang, fill the memory or end the process."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import isfinite
from pathlib import Path
from typing import Any

import yaml

from torquerig.errors import InputError

LONGEST_TEXT = 4_000_000  # [byte] the largest shipped file has 8 000; PyYAML takes about 100 bytes for each
DEEPEST = 40  # [levels] the deepest shipped file has 8; the parser calls itself once a level
MOST_REPEATED = 100_000  # [values] of a file with aliases, each alias counted with all that it repeats
LARGEST_INTEGER = 2**63 - 1  # larger ones lose digits, or overflow, where they are calculated with
CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")  # YAML has them only as escapes within quotes
LARGEST_NUMBER = 1e30  # the largest number of a rig in any unit is near 1e15; squares of this one are still finite


class Loader(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # type: ignore[misc]
    """The safe loader with the scalar rules of YAML 1.2."""

    yaml_implicit_resolvers: dict[str, list[tuple[str, re.Pattern[str]]]] = {}  # noqa: RUF012 (PyYAML's own protocol)


for _tag, _pattern, _first in (
    ("bool", r"^(?:true|True|TRUE|false|False|FALSE)$", "tTfF"),
    ("null", r"^(?:null|Null|NULL|~|)$", "nN~\0"),
    ("int", r"^[-+]?(?:0|[1-9][0-9]*)$", "-+0123456789"),
    ("float", r"^[-+]?(?:\.[0-9]+|(?:0|[1-9][0-9]*)(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?$", "-+0123456789."),
):
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(_pattern), list(_first))
# an empty scalar (``key:``) is null; PyYAML looks it up under the empty first character
Loader.add_implicit_resolver("tag:yaml.org,2002:null", re.compile(r"^$"), [""])


def read_yaml(text: str, path: Path) -> tuple[Any, yaml.Node]:
    """Return the data of a YAML text that came from ``path``, and the nodes that remember its lines.

    Raises
    ------
    InputError
        With file and line: no YAML, empty, too long or too deep, an alias of itself or of too much, a tag, a key that
        is empty, a list, a mapping or there twice, a number that no calculation can hold.
    """
    _refuse_binary(text, path)
    try:
        _refuse_unbounded(text, path)
        node = yaml.compose(text, Loader=Loader)
        if node is None:
            raise InputError(f"{path}: the file is empty; copy a shipped one and change it")
        _refuse_bad_entries(node, path)
        loader = Loader("")
        try:
            return loader.construct_document(node), node
        finally:
            loader.dispose()
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = f":{mark.line + 1}" if mark else ""
        problem = " ".join(str(getattr(error, "problem", None) or error).split())
        raise InputError(
            f"{path}{line}: not YAML: {problem}; check the indentation and the colons of this line and the one above"
        ) from None


def _refuse_binary(text: str, path: Path) -> None:
    """Raise InputError for a control character that no text file has."""
    found = CONTROL.search(text)
    if found:
        line = text.count("\n", 0, found.start()) + 1
        raise InputError(f"{path}:{line}: holds the control character {ord(found[0]):#04x}; delete it, or save the "
                         "file as UTF-8 text")  # fmt: skip


def _refuse_unbounded(text: str, path: Path) -> None:
    """Raise InputError for depth, tags and aliases; the events are parsed one by one, without recursion."""
    open_at: list[tuple[str | None, int]] = []  # the anchor of each open collection, and the values before it
    sizes: dict[str, int] = {}  # of each anchor [values]
    values = 0
    for event in yaml.parse(text, Loader=Loader):
        if isinstance(event, yaml.CollectionEndEvent):
            anchor, before = open_at.pop()
            if anchor:
                sizes[anchor] = values - before
        elif isinstance(event, yaml.NodeEvent):
            values += sizes.get(event.anchor or "", 1) if isinstance(event, yaml.AliasEvent) else 1
            _refuse_event(event, open_at, values, path)
            if isinstance(event, yaml.CollectionStartEvent):
                open_at.append((event.anchor, values - 1))
            elif isinstance(event, yaml.ScalarEvent) and event.anchor:
                sizes[event.anchor] = 1


def _refuse_event(event: Any, open_at: Sequence[tuple[str | None, int]], values: int, path: Path) -> None:
    problem = None
    if isinstance(event, yaml.AliasEvent):
        if event.anchor in {anchor for anchor, _ in open_at}:
            problem = f"the alias *{event.anchor} is inside of what it repeats; write the value"
        elif values > MOST_REPEATED:
            problem = f"the aliases repeat more than {MOST_REPEATED} values; write the values"
    elif event.tag is not None:
        problem = f"{_written_tag(event.tag)} is a tag; delete it, and write text in quotes"
    elif len(open_at) >= DEEPEST and isinstance(event, yaml.CollectionStartEvent):
        problem = f"is nested more than {DEEPEST} levels deep; close the brackets before it"
    if problem:
        raise InputError(f"{path}:{event.start_mark.line + 1}: {problem}")


def _written_tag(tag: str) -> str:
    return tag.replace("tag:yaml.org,2002:", "!!", 1)


def _refuse_bad_entries(root: yaml.Node, path: Path) -> None:
    """Raise InputError for a key that is not plain or there twice, and for a number beyond calculation."""
    for node in _every_node(root):
        if isinstance(node, yaml.ScalarNode):
            _refuse_number(node, path)
            if "\0" in node.value:
                raise InputError(f"{path}:{node.start_mark.line + 1}: holds the escape of a NUL character; delete it")
        if not isinstance(node, yaml.MappingNode):
            continue
        seen: dict[str, int] = {}
        for name, _ in node.value:
            line = name.start_mark.line + 1
            if not isinstance(name, yaml.ScalarNode) or name.tag == "tag:yaml.org,2002:null":
                kind = "a list" if isinstance(name, yaml.SequenceNode) else "a mapping"
                kind = "empty" if isinstance(name, yaml.ScalarNode) else kind
                raise InputError(f"{path}:{line}: the key before ':' is {kind}; write a word or a number")
            if name.value in seen:
                raise InputError(
                    f"{path}:{line}: the key {name.value!r} is already in line {seen[name.value]}; keep one of them"
                )
            seen[name.value] = line


def _every_node(root: yaml.Node) -> Iterator[yaml.Node]:
    """Yield each node once, however many aliases lead to it."""
    waiting, seen = [root], set()
    while waiting:
        node = waiting.pop()
        if id(node) in seen:
            continue
        seen.add(id(node))
        yield node
        if isinstance(node, yaml.SequenceNode):
            waiting += reversed(node.value)
        elif isinstance(node, yaml.MappingNode):
            waiting += [one for pair in reversed(node.value) for one in reversed(pair)]


def _refuse_number(node: yaml.ScalarNode, path: Path) -> None:
    what = node.tag.rpartition(":")[2]
    if what not in ("int", "float"):
        return
    shown = node.value if len(node.value) <= 24 else f"{node.value[:20]}... ({len(node.value)} characters)"
    number = float(node.value)
    problem = beyond_calculation(number)
    if problem is None and what == "int" and abs(int(node.value)) > LARGEST_INTEGER:
        problem = f"is more than the largest whole number, {LARGEST_INTEGER}; write it with an exponent, such as 1e20"
    if problem is None and number == 0 and re.search(r"[1-9]", re.split("[eE]", node.value)[0]):
        problem = "is too small to be held as a number; write 0"
    if problem:
        raise InputError(f"{path}:{node.start_mark.line + 1}: {shown} {problem}")


def beyond_calculation(number: float) -> str | None:
    """Return what is wrong with a number of any unit that no calculation can hold, and the remedy; None for others."""
    if isfinite(number) and abs(number) <= LARGEST_NUMBER:
        return None
    return f"is out of range; no number may be above {LARGEST_NUMBER:g}, so write the value with a larger unit"
