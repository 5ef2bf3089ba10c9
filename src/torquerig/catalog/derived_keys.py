"""Keys of a file that were derived from other keys of it, with the lines of what was written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import yaml

from torquerig.document import Document

MAPPING, TEXT = "tag:yaml.org,2002:map", "tag:yaml.org,2002:str"


def with_derived_keys(
    document: Document, data: Any, *, origins: Mapping[tuple[str, ...], tuple[str | int, ...]]
) -> Document:
    """Return the document with ``data`` that was derived from it, so that errors give the line of what was written.

    ``origins`` gives for each derived path of keys the written path from which it comes.
    """
    node = document.node
    for path, written in origins.items():
        at = yaml.Mark(str(document.path), 0, _line(document.node, written), 0, None, 0)
        node = _node_with(node, path, yaml.ScalarNode(TEXT, "", at, at))
    return replace(document, data=data, node=node)


def _line(node: yaml.Node, keys: Iterable[str | int]) -> int:
    """Return the line (from 0) of the last of ``keys`` that is there."""
    line = node.start_mark.line
    for key in keys:
        pairs = node.value if isinstance(node, yaml.MappingNode) else []
        found = next(((name.start_mark.line, value) for name, value in pairs if name.value == str(key)), None)
        if found is None:
            break
        line, node = found
    return int(line)


def _node_with(node: yaml.Node, path: tuple[str, ...], leaf: yaml.Node) -> yaml.Node:
    if not path:
        return leaf
    pairs = node.value if isinstance(node, yaml.MappingNode) else []
    held = next((value for name, value in pairs if name.value == path[0]), None)
    start = leaf.start_mark if held is None else held.start_mark
    inner = _node_with(held or yaml.MappingNode(MAPPING, [], start, start), path[1:], leaf)
    kept = [(name, inner if name.value == path[0] else value) for name, value in pairs]
    if held is None:
        kept.append((yaml.ScalarNode(TEXT, path[0], start, start), inner))
    return yaml.MappingNode(MAPPING, kept, node.start_mark, node.end_mark)
