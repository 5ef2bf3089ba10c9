"""Digest of values by what they hold: equal values give the same digest in every process."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Mapping, Sequence, Set
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import PurePath
from typing import Any

from torquerig.cases.case import plain

BYTES = 16  # of a digest: two different contents of 10^15 agree with a probability below 1e-8


def content_digest(*values: Any) -> str:
    """Return the digest of values: scalars, texts, paths, arrays, mappings, sequences, dataclasses and pydantic models.

    The order of a mapping counts, because the order of a scenario's parts does. ``1``, ``1.0`` and ``True`` differ.

    Raises
    ------
    TypeError
        For a value whose content is not known, such as a function.
    """
    digest = hashlib.blake2b(digest_size=BYTES)
    for value in values:
        _feed(digest, value)
    return digest.hexdigest()


def _feed(digest: Any, value: Any) -> None:
    value = plain(value)
    if value is None or isinstance(value, bool | int | str | bytes | PurePath):
        _feed_bytes(digest, type(value).__name__ if not isinstance(value, PurePath) else "path", _bytes_of(value))
    elif isinstance(value, float):
        _feed_bytes(digest, "float", struct.pack("<d", value))
    elif isinstance(value, Enum):
        _feed_bytes(digest, type(value).__qualname__, value.name.encode())
    elif hasattr(value, "tobytes") and hasattr(value, "dtype"):
        _feed_bytes(digest, f"array {value.dtype.str} {value.shape}", value.tobytes())
    elif isinstance(value, Mapping):
        _feed_bytes(digest, "mapping", str(len(value)).encode())
        for key, one in value.items():
            _feed(digest, key)
            _feed(digest, one)
    elif isinstance(value, Set):
        _feed(digest, sorted(content_digest(one) for one in value))
    elif isinstance(value, Sequence):
        _feed_bytes(digest, "sequence", str(len(value)).encode())
        for one in value:
            _feed(digest, one)
    else:
        _feed_bytes(digest, type(value).__qualname__, b"")
        _feed(digest, _fields_of(value))


def _feed_bytes(digest: Any, kind: str, content: bytes) -> None:
    digest.update(f"{kind} {len(content)}\0".encode() + content)


def _bytes_of(value: Any) -> bytes:
    return value if isinstance(value, bytes) else str(value).encode("utf-8", "surrogatepass")


def _fields_of(value: Any) -> dict[str, Any]:
    if is_dataclass(value) and not isinstance(value, type):
        return {one.name: getattr(value, one.name) for one in fields(value)}
    if hasattr(type(value), "__pydantic_fields__"):
        return {name: getattr(value, name) for name in type(value).__pydantic_fields__}
    raise TypeError(f"a {type(value).__name__} cannot be part of the key of a kept result")
