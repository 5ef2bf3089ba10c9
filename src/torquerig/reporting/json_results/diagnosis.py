"""The JSON of ``torquerig diagnose``: its fixed form as classes, from which its schema derives; and of ``--check``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal


@dataclass(frozen=True, kw_only=True)
class Ci95:
    """A value with its 95 % interval and unit."""

    value: float
    ci95: list[float]
    unit: str


@dataclass(frozen=True, kw_only=True)
class MismatchJson:
    """One place where recordings and model differ."""

    domain: str
    axis: str
    at: float
    width: float
    recordings: list[str]
    excess_dB: float  # noqa: N815 (the contract's name)
    share_of_misfit: float
    p_value: float


@dataclass(frozen=True, kw_only=True)
class FindingJson:
    """One effect that the model lacks."""

    mechanism: str
    variant: str | None = None
    part: str | None = None
    explanation: str
    confidence: float
    parameters: dict[str, Ci95]
    equivalent_to: list[str]
    next_experiment: str | None
    size: dict[str, Any] | None = None
    evidence: dict[str, Any] | None = None
    alternatives: list[dict[str, Any]] | None = None


@dataclass(frozen=True, kw_only=True)
class FitJson:
    """How well the model fits held-out data before and after."""

    metric: str
    before: dict[str, float]
    after: dict[str, float]
    improvement: dict[str, Any] | None


@dataclass(frozen=True, kw_only=True)
class RecordingJson:
    """A recording and what it was used for: ``fit``, ``held_out``, ``split`` (a part of each) or ``none``."""

    file: str
    speed_rpm: float | None
    used_for: str


@dataclass(frozen=True, kw_only=True)
class DiagnosisJson:
    """The diagnosis of recordings of one rig."""

    schema: str
    verdict: Literal["adequate", "missing_physics", "unexplained", "setup_error"]
    mismatch: list[MismatchJson]
    findings: list[FindingJson]
    fit: FitJson
    model: str | None
    recordings: list[RecordingJson]
    set_aside: dict[str, str] | None = None
    next_experiment: str | None = None
    remarks: list[str] | None = None
    setup: list[dict[str, Any]] | None = None
    unnamed: list[dict[str, Any]] | None = None
    rms: dict[str, Any] | None = None
    upper_limits: list[dict[str, Any]] | None = None
    provenance: dict[str, Any] | None = None


@dataclass(frozen=True)
class UpperLimit:
    """The smallest size of a mechanism that recordings would show, at a place; ``grows`` is down for a cutoff."""

    mechanism: str
    parameter: str
    value: float
    unit: str
    place: str
    grows: Literal["up", "down"]


@dataclass(frozen=True)
class InseparablePair:
    """Two hypotheses that recordings do not separate, and which run does."""

    one: str
    other: str
    mechanisms: tuple[str, str]
    next_experiment: str


@dataclass(frozen=True)
class DiagnoseCheckResult:
    """What a diagnosis would compare, line by line as ``torquerig diagnose --check`` prints it.

    Also what the recordings would show, and what they cannot tell apart.
    """

    lines: tuple[str, ...]
    upper_limits: tuple[UpperLimit, ...] = ()
    inseparable: tuple[InseparablePair, ...] = ()
