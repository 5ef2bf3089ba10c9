"""The JSON of ``torquerig diagnose``: its fixed form as classes, from which its schema derives; and of ``--check``."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NotRequired

from typing_extensions import TypedDict


class Ci95(TypedDict):
    """A value with its 95 % interval and unit."""

    value: float
    ci95: list[float]
    unit: str


class MismatchJson(TypedDict):
    """One place where recordings and model differ."""

    domain: str
    axis: str
    at: float
    width: float
    recordings: list[str]
    excess_dB: float
    share_of_misfit: float
    p_value: float


class FindingJson(TypedDict):
    """One effect that the model lacks."""

    mechanism: str
    variant: NotRequired[str]
    part: NotRequired[str | None]
    explanation: str
    confidence: float
    parameters: dict[str, Ci95]
    equivalent_to: list[str]
    next_experiment: str | None
    evidence: NotRequired[dict[str, Any]]
    rivals: NotRequired[list[dict[str, Any]]]


class FitJson(TypedDict):
    """How well the model fits held-out data before and after."""

    metric: str
    before: dict[str, float]
    after: dict[str, float]
    improvement: dict[str, Any] | None


class RecordingJson(TypedDict):
    """A recording and what it was used for."""

    file: str
    speed_rpm: float | None
    used_for: str


class DiagnosisJson(TypedDict):
    """The diagnosis of recordings of one rig."""

    schema: str
    verdict: str
    mismatch: list[MismatchJson]
    findings: list[FindingJson]
    fit: FitJson
    model: str | None
    recordings: list[RecordingJson]
    set_aside: NotRequired[dict[str, str]]
    next_experiment: NotRequired[str | None]
    remarks: NotRequired[list[str]]
    setup: NotRequired[list[dict[str, Any]]]
    unnamed: NotRequired[list[dict[str, Any]]]
    rms: NotRequired[dict[str, Any]]
    upper_limits: NotRequired[list[dict[str, Any]]]
    provenance: NotRequired[dict[str, Any]]


@dataclass(frozen=True)
class DiagnoseCheckResult:
    """What a diagnosis would compare, line by line as ``torquerig diagnose --check`` prints it."""

    lines: tuple[str, ...]
