"""What is wrong with a file, by key: the sentences of the existing checks, each with its field and its part."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import yaml

from torquerig.document import Document
from torquerig.studio.session.yaml_spans import Keys


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong: where, and one sentence with the remedy.

    Parameters
    ----------
    keys : tuple of str or int
        Path of the field in the file, ``("rig", "gearbox", "ratio")``; empty where it concerns the whole file.
    part : str or None
        The part of the rig, channel or alternative that it belongs to: the second key.
    sentence : str
        Without file, line and path.
    file : Path
        The file to correct: the one that is open, or another that it uses (filters, catalog).
    line : int or None
        Line in that file, from 1.
    """

    keys: Keys
    part: str | None
    sentence: str
    file: Path
    line: int | None = None

    @property
    def field(self) -> str:
        """The path with dots, ``rig.gearbox.ratio``."""
        return ".".join(map(str, self.keys))

    def text(self) -> str:
        """Return place and sentence in one line."""
        where = f"{self.file.name}:{self.line}" if self.line else self.file.name
        return f"{where}: {self.field}: {self.sentence}" if self.keys else f"{where}: {self.sentence}"


def problems_of(error: Exception, document: Document | None, path: Path) -> tuple[Problem, ...]:
    """Return the problems that an error of the checks states, one a line.

    Parameters
    ----------
    error : Exception
        Of torquerig; its text begins with ``file:line: key: `` as far as these are known.
    document : Document or None
        The file as it was read; None where it is no YAML.
    path : Path
        The file that is open.
    """
    found = [_problem(line, document, path) for line in str(error).splitlines() if line.strip()]
    return tuple(dict.fromkeys(found)) or (Problem((), None, f"{type(error).__name__}; the file cannot be used", path),)


def _problem(text: str, document: Document | None, path: Path) -> Problem:
    match = re.match(r"(?P<file>.+?\.(?:ya?ml|xlsx|csv|tsv))(?::(?P<line>\d+))?: (?P<rest>.*)", text)
    if match is None:
        return Problem((), None, text, path)
    file, rest = Path(match["file"]), match["rest"]
    line = int(match["line"]) if match["line"] else None
    if file != path:
        return Problem((), None, rest, file, line)
    if document is None:
        return Problem((), None, rest, path, line)
    head, colon, sentence = rest.partition(": ")
    keys = _known_keys(document.node, head) if colon else ()
    if not keys:
        keys, sentence = (_keys_of_line(document.node, line) if line else ()), rest
    part = str(keys[1]) if len(keys) > 1 else None
    return Problem(keys, part, sentence, path, line)


def _known_keys(node: yaml.Node, dotted: str) -> Keys:
    """Return the path that a text with dots stands for; empty where the file has no such path.

    A name may contain a dot. The last key may be one that is missing.
    """
    return next(_paths(node, dotted.split(".")), ())


def _paths(node: yaml.Node, words: Sequence[str]) -> Iterator[Keys]:
    if not words:
        yield ()
        return
    for taken in range(1, len(words) + 1):
        name = ".".join(words[:taken])
        for key, value in _children(node):
            if str(key) == name:
                yield from ((key, *below) for below in _paths(value, words[taken:]))


def _keys_of_line(node: yaml.Node, line: int) -> Keys:
    """Return the path of the last key that begins in a line, from 1; empty where none does."""
    found: Keys = ()
    for key, value in _children(node):
        begin = _line_of(node, key, value)
        if begin > line - 1:
            break
        below = _keys_of_line(value, line) if isinstance(value, yaml.CollectionNode) else ()
        if below:
            found = (key, *below)
        elif begin == line - 1:
            found = (key,)
            break
    return found


def _children(node: yaml.Node) -> Iterator[tuple[str | int, yaml.Node]]:
    if isinstance(node, yaml.MappingNode):
        yield from ((name.value, value) for name, value in node.value)
    elif isinstance(node, yaml.SequenceNode):
        yield from enumerate(node.value)


def _line_of(node: yaml.Node, key: str | int, value: yaml.Node) -> int:
    if isinstance(node, yaml.MappingNode):
        return next(int(name.start_mark.line) for name, _ in node.value if name.value == key)
    return int(value.start_mark.line)
