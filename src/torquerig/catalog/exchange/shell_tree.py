"""The submodels of an Asset Administration Shell as trees, from JSON, XML (AAS 3.0) or an AASX package."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from torquerig.catalog.exchange.untrusted import json_of, parts_of, read_bytes, xml_of
from torquerig.errors import InputError

SPECIFICATION = "/aasx/relationships/aas-spec"  # end of the relationship's type, with and without www.
CONTAINERS = ("submodelElements", "value", "statements")
MOST_ELEMENTS = 50_000


@dataclass(frozen=True)
class Element:
    """One submodel or submodel element.

    Parameters
    ----------
    id_short, kind : str
        Name, and model type in lower case: ``property``, ``entity``, ``file``, ``range``.
    meaning : tuple of str
        Values of the keys of its semantic id.
    value : str
        Of a property or file; empty else.
    low, high : str
        Of a range; empty else.
    children : tuple of Element
    """

    id_short: str
    kind: str
    meaning: tuple[str, ...] = ()
    value: str = ""
    low: str = ""
    high: str = ""
    children: tuple[Element, ...] = field(default=())

    def child(self, id_short: str) -> Element | None:
        """Return the first child of this name; None where there is none."""
        return next((one for one in self.children if one.id_short == id_short), None)

    def all_of(self, id_short: str) -> list[Element]:
        """Return the children of this name, also those with a running number (``MainComponent01``)."""
        return [one for one in self.children if one.id_short.rstrip("0123456789_") == id_short]

    def text(self, id_short: str) -> str:
        """Return the value of a child, stripped; empty where there is none."""
        found = self.child(id_short)
        return found.value.strip() if found else ""


@dataclass(frozen=True)
class ShellFile:
    """The submodels of a file, and the further parts of its package by absolute name."""

    submodels: tuple[Element, ...]
    parts: Mapping[str, bytes]


def read_shell(path: Path) -> ShellFile:
    """Return the submodels of a ``.json``, ``.xml`` or ``.aasx`` file.

    Raises
    ------
    InputError
        Where the file is damaged, beyond the limits of ``untrusted``, or holds no submodels.
    """
    content = read_bytes(path)
    parts: Mapping[str, bytes] = {}
    if content[:2] == b"PK":
        parts = parts_of(content, path)
        found = tuple(
            one for name in _specifications(parts, path) for one in _submodels(parts[name], f"{path}: {name}")
        )
    else:
        found = tuple(_submodels(content, str(path)))
    if not found:
        raise InputError(f"{path}: holds no submodels; export the shell with its submodels")
    return ShellFile(found, parts)


def _specifications(parts: Mapping[str, bytes], path: Path) -> list[str]:
    """Return the parts with the shell: those that the relationships name, else every JSON and XML part of /aasx."""
    named: list[str] = []
    for name, data in parts.items():
        if not name.lower().endswith(".rels"):
            continue
        folder = posixpath.dirname(posixpath.dirname(name)) or "/"
        relations = xml_of(data, f"{path}: {name}").iter()
        targets = (str(one.get("Target", "")) for one in relations if str(one.get("Type", "")).endswith(SPECIFICATION))
        named += [posixpath.normpath(posixpath.join(folder, one)) for one in targets]
    known = [name for name in dict.fromkeys(named) if name in parts]
    if known:
        return known
    loose = [name for name in parts if name.startswith("/aasx/") and name.lower().endswith((".json", ".xml"))]
    if not loose:
        raise InputError(f"{path}: has no part with a shell in JSON or XML; export it again")
    return loose


def _submodels(content: bytes, where: str) -> Iterator[Element]:
    if content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] in (b"{", b"["):
        data = json_of(content, where)
        listed = data.get("submodels", []) if isinstance(data, dict) else data
        left = [MOST_ELEMENTS]
        for one in listed if isinstance(listed, list) else []:
            if isinstance(one, dict):
                yield _from_json(one, where, left)
        return
    root = xml_of(content, where)
    for one in root.iter():
        if _tag(one) == "submodel":
            yield _from_xml(one)


def _from_json(data: Mapping[str, Any], where: str, left: list[int]) -> Element:
    left[0] -= 1
    if left[0] < 0:
        raise InputError(f"{where}: has more than {MOST_ELEMENTS} elements; export the submodel alone")
    kind = str(data.get("modelType", "submodel")).lower()
    inner: list[Any] = next((data[key] for key in CONTAINERS if isinstance(data.get(key), list)), [])
    children = () if kind == "multilanguageproperty" else tuple(
        _from_json(one, where, left) for one in inner if isinstance(one, dict)
    )  # fmt: skip
    value = data.get("value", "")
    keys = data.get("semanticId", {})
    meaning = keys.get("keys", []) if isinstance(keys, dict) else []
    return Element(
        id_short=str(data.get("idShort", "")), kind=kind,
        meaning=tuple(str(one.get("value", "")) for one in meaning if isinstance(one, dict)),
        value=_first_text(value), low=str(data.get("min", "")), high=str(data.get("max", "")), children=children,
    )  # fmt: skip


def _first_text(value: Any) -> str:
    if isinstance(value, list):
        return next((str(one["text"]) for one in value if isinstance(one, dict) and "text" in one), "")
    return "" if value is None or isinstance(value, dict) else str(value)


def _from_xml(node: ET.Element) -> Element:
    inside = {_tag(one): one for one in node}
    container = next((inside[key] for key in CONTAINERS if key in inside and len(inside[key])), None)
    kind = _tag(node).lower()
    texts = [] if container is None else [one for one in container.iter() if _tag(one) == "text"]
    holds_text = kind == "multilanguageproperty"
    semantic = inside.get("semanticId")
    plain = inside.get("value") if container is None else None
    value = _text(texts[0] if texts else None) if holds_text else _text(plain)
    return Element(
        id_short=_text(inside.get("idShort")), kind=kind,
        meaning=() if semantic is None else tuple(_text(one) for one in semantic.iter() if _tag(one) == "value"),
        value=value,
        low=_text(inside.get("min")), high=_text(inside.get("max")),
        children=() if container is None or holds_text else tuple(_from_xml(one) for one in container),
    )  # fmt: skip


def _tag(node: ET.Element) -> str:
    return str(node.tag).rpartition("}")[2]


def _text(node: ET.Element | None) -> str:
    return "" if node is None or node.text is None else node.text.strip()
