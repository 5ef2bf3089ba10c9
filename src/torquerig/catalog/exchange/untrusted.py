"""Files that others wrote, read within limits: none hangs, fills the memory, writes elsewhere or opens an address."""

from __future__ import annotations

import json
import zipfile
from collections.abc import Mapping
from io import BytesIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from torquerig.errors import InputError

LARGEST_FILE = 50_000_000  # [byte] packed, with pictures and documents
LARGEST_PARTS = 20_000_000  # [byte] JSON, XML and CSV of a package, unpacked; the template of IDTA 02021 has 500 000
MOST_PARTS = 5_000
READABLE = (".json", ".xml", ".csv", ".rels", ".txt")
DEEPEST = 60  # [levels] of JSON; the template has 25


def read_bytes(path: Path) -> bytes:
    """Return the content of a file; InputError where it is missing or larger than ``LARGEST_FILE``."""
    try:
        with path.open("rb") as file:  # a device or pipe may have no end
            content = file.read(LARGEST_FILE + 1)
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror}); check the path") from None
    if len(content) > LARGEST_FILE:
        raise InputError(f"{path}: has more than {LARGEST_FILE / 1e6:.0f} MB; export it without documents")
    return content


def parts_of(content: bytes, path: Path) -> Mapping[str, bytes]:
    """Return the readable parts of a ZIP archive by name; nothing is unpacked to the disk.

    Raises
    ------
    InputError
        Where it is no archive, damaged, encrypted, or unpacks to more than ``LARGEST_PARTS``.
    """
    found: dict[str, bytes] = {}
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            if len(archive.infolist()) > MOST_PARTS:
                raise InputError(f"{path}: has {len(archive.infolist())} parts, more than {MOST_PARTS}; export it anew")
            left = LARGEST_PARTS
            for part in archive.infolist():
                if not part.filename.lower().endswith(READABLE):
                    continue
                with archive.open(part) as file:  # the stated size may be wrong
                    data = file.read(left + 1)
                left -= len(data)
                if left < 0:
                    raise InputError(f"{path}: unpacks to more than {LARGEST_PARTS / 1e6:.0f} MB; export it anew")
                found["/" + part.filename.lstrip("/")] = data
    except InputError:
        raise
    except Exception as error:  # zipfile and zlib have several, and a damaged directory gives any
        raise InputError(f"{path}: is no whole package ({type(error).__name__}); export it again") from None
    return found


def xml_of(content: bytes, where: str) -> ET.Element:
    """Return the root of an XML document; InputError where it is damaged, no UTF-8, or declares a document type."""
    plain = content.replace(b"\0", b"").lower()  # UTF-16 has a NUL in each letter
    if b"<!doctype" in plain or b"<!entity" in plain:
        raise InputError(f"{where}: declares a document type, which no exporter writes; export it again")
    try:
        return ET.fromstring(content.decode("utf-8-sig"))  # noqa: S314 - no entities are left to expand
    except (ET.ParseError, ValueError, RecursionError) as error:
        raise InputError(f"{where}: is no XML in UTF-8 ({error}); export it again") from None


def json_of(content: bytes, where: str) -> Any:
    """Return the data of a JSON document; InputError where it is damaged, no UTF-8, or too deep."""
    try:
        data = json.loads(content.decode("utf-8-sig"), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:
        raise InputError(f"{where}: is no JSON in UTF-8 ({error}); export it again") from None
    if _depth(data) > DEEPEST:
        raise InputError(f"{where}: is nested more than {DEEPEST} levels deep; export it again")
    return data


def _refuse_constant(word: str) -> None:
    raise ValueError(f"{word} is no number of JSON")


def _depth(data: Any) -> int:
    deepest, waiting = 0, [(data, 1)]
    while waiting:
        one, level = waiting.pop()
        deepest = max(deepest, level)
        inner = one.values() if isinstance(one, dict) else one if isinstance(one, list) else ()
        if level <= DEEPEST:
            waiting += [(value, level + 1) for value in inner]
    return deepest
