"""Keys of the YAML of a user's matrix."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, ClassVar

from torquerig.decide.criterion import Better, Kind
from torquerig.decide.kesselring import TEACHING
from torquerig.decide.matrix_io.file_schema import STRICT, GoalText, ScaleText


@dataclass(frozen=True, kw_only=True)
class RequirementText:
    """A limit that must be met."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    min: float | None = None
    max: float | None = None
    in_question: str = ""


@dataclass(frozen=True, kw_only=True)
class IndifferenceText:
    """Largest difference of two values that count as the same."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    absolute: float = 0.0
    relative: float = 0.0


@dataclass(frozen=True, kw_only=True)
class CriterionText:
    """One criterion; ``catalog`` names the key of a motor's file that its cells are read from."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    unit: str = "1"
    better: Better = Better.MORE
    band: tuple[float, float] | None = None
    requirement: RequirementText | None = None
    indifference: IndifferenceText = field(default_factory=IndifferenceText)
    points: tuple[tuple[float, float], ...] | None = None
    weight: float = 0.0
    kind: Kind = Kind.TECHNICAL
    purpose: str = ""
    catalog: str = ""


@dataclass(frozen=True, kw_only=True)
class OriginText:
    """A catalog value or measurement behind a cell."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    name: str
    shown: str = "?"
    evidence: str = ""
    source: str = ""


@dataclass(frozen=True, kw_only=True)
class OverrideText:
    """A value or points set by hand, with the reason."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    reason: str = ""
    value: str | float | None = None
    points: float | None = None


@dataclass(frozen=True, kw_only=True)
class CellText:
    """A cell with more than a number."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    value: str | float | None = None
    low: str | float | None = None
    high: str | float | None = None
    text: str = ""
    source: str = ""
    evidence: str = ""
    note: str = ""
    unknown_reason: str = ""
    fact: str = ""
    metric: str = ""
    origins: tuple[OriginText, ...] = ()
    by_hand: OverrideText | None = None


@dataclass(frozen=True, kw_only=True)
class UncertaintyText:
    """Uncertainty: half-widths of the points [points] and of the raw weights [share of them]."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    scores: float = 0.5
    weights: float = 0.25


@dataclass(frozen=True, kw_only=True)
class CostText:
    """The criterion with the costs, and the highest accepted cost."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    criterion: str
    permissible: float


@dataclass(frozen=True, kw_only=True)
class AliasText:
    """Several names of one thing, the first being the one to use."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    names: tuple[str, ...]
    reason: str = ""


@dataclass(frozen=True, kw_only=True)
class MatrixText:
    """The whole file."""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT
    criteria: dict[str, CriterionText]
    alternatives: dict[str, dict[str, Any] | None]
    name: str = "matrix"
    baseline: str = ""
    goal: GoalText | None = None
    scale: ScaleText = field(default_factory=lambda: ScaleText(min=TEACHING.p_min, max=TEACHING.p_max))
    draws: int = 10_000
    seed: int = 0
    uncertainty: UncertaintyText = field(default_factory=UncertaintyText)
    motors: dict[str, str] = field(default_factory=dict)
    cost: CostText | None = None
    aliases: tuple[AliasText, ...] = ()
    history: tuple[str, ...] = ()
