"""The schema of a class that sections of files are read into."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from pydantic import TypeAdapter

Model = TypeVar("Model")
_MADE: dict[type, TypeAdapter[Any]] = {}


def schema_of(kind: type[Model]) -> TypeAdapter[Model]:
    """Return the schema of a class, made once: to make one takes a hundred times as long as to read by it."""
    from pydantic import TypeAdapter

    if kind not in _MADE:
        _MADE[kind] = TypeAdapter(kind)
    return _MADE[kind]
