"""Parts of the YAML that published tables and a user's matrix have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

STRICT: dict[str, Any] = {"extra": "forbid"}


@dataclass(frozen=True, kw_only=True)
class GoalText:
    """The stated goal, and the words that identify a criterion for it."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    name: str
    words: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class ScaleText:
    """The lowest and the highest points."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    min: float
    max: float
