"""The outcome of a diagnosis, as values; its JSON is fixed by the contract."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from torquerig.inference.answer.mismatch import Mismatch

SCHEMA = "torquerig.diagnosis/1"
Verdict = Literal["adequate", "missing_physics", "unexplained"]


@dataclass(frozen=True, kw_only=True)
class Stated:
    """One identifying parameter: value with its 95 % interval, in the contract's unit."""

    value: float
    low: float
    high: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Finding:
    """One effect that was left out of the model.

    ``gain`` is what the misfit fell by, ``share`` the part of it at the effect's places that went, ``rest`` the mean
    square that the finished model leaves there (1 by chance). ``alternatives`` holds (mechanism, gain of the misfit) of
    the other hypotheses that were fitted, best first.
    """

    mechanism: str
    variant: str
    explanation: str
    confidence: float
    parameters: Mapping[str, Stated]
    gain: float
    share: float = 1.0
    rest: float = 0.0
    alternatives: tuple[tuple[str, float], ...] = ()
    equivalent_to: tuple[str, ...] = ()
    next_experiment: str | None = None


@dataclass(frozen=True, kw_only=True)
class HeldOut:
    """Misfit on data that no fit has seen: of the nominal model, the calibrated one, and the completed one.

    ``by_twin`` where one of them cannot be simulated, so that linear twins were judged, values not being compared.
    ``explained`` is the part of what the calibrated one misses that the completed one explains, at its places [1].
    """

    nominal: float
    before: float
    after: float
    improvement: tuple[float, float, float]  # value, low, high
    by_twin: bool = False
    explained: float = 1.0


@dataclass(frozen=True, kw_only=True)
class UsedRecording:
    """A recording and what it served for."""

    file: str
    speed_rpm: float
    used_for: str


@dataclass(frozen=True, kw_only=True)
class Diagnosis:
    """What a diagnosis says.

    ``set_aside`` holds a reason for each mechanism that is neither found nor a rival of what is; under measured motion
    for rivals too, which are judged again beside what was found. ``next_experiment`` is the run that would tell between
    the hypotheses that explain part of an ``unexplained`` rest, where there are two or more.
    """

    verdict: Verdict
    mismatch: tuple[Mismatch, ...]
    findings: tuple[Finding, ...]
    fit: HeldOut
    recordings: tuple[UsedRecording, ...]
    model: str | None = None
    remarks: tuple[str, ...] = ()
    set_aside: Mapping[str, str] = field(default_factory=dict)
    next_experiment: str | None = None


METRIC = (
    "Mean squared standardised residual of held-out data. Lower is better; a true model is below 1. "
    "The data are line amplitudes, spectrum in eighth octaves, slow torque and distribution of values; also contact "
    "losses if backlash is a hypothesis. "
    "Each residual is divided by its standard deviation; beyond 4 it counts linearly (pseudo-Huber). "
    "The reference is a simulation of the model, with the line phases of the fitted data if backlash is a hypothesis. "
    "As in a likelihood, twice the logarithm of the random variation assumed for the slow torque is added, relative to "
    "the nominal model."
)


def as_json(diagnosis: Diagnosis) -> dict[str, Any]:
    """Return the diagnosis in the contract's form, with ``alternatives``, ``set_aside`` and ``remarks``."""
    fit, improvement = diagnosis.fit, diagnosis.fit.improvement
    return {
        "schema": SCHEMA,
        "verdict": diagnosis.verdict,
        "mismatch": [
            {
                "domain": each.domain, "axis": each.axis, "at": _digits(each.at), "width": _digits(each.width),
                "recordings": list(each.recordings), "excess_dB": _digits(each.excess_dB),
                "share_of_misfit": _digits(each.share_of_misfit), "p_value": _digits(each.p_value),
            }
            for each in diagnosis.mismatch
        ],
        "findings": [_finding(finding) for finding in diagnosis.findings],
        "fit": {
            "metric": METRIC,
            "before": {"heldout_misfit": _digits(fit.before), "nominal": _digits(fit.nominal)},
            "after": {"heldout_misfit": _digits(fit.after)},
            "improvement": {"value": _digits(improvement[0]), "ci95": [_digits(end) for end in improvement[1:]]},
        },
        "model": diagnosis.model,
        "recordings": [
            {"file": used.file, "speed_rpm": _digits(used.speed_rpm), "used_for": used.used_for}
            for used in diagnosis.recordings
        ],
        "set_aside": dict(diagnosis.set_aside),
        "next_experiment": diagnosis.next_experiment,
        "remarks": list(diagnosis.remarks),
    }  # fmt: skip


def _finding(finding: Finding) -> dict[str, Any]:
    return {
        "mechanism": finding.mechanism,
        **({"variant": finding.variant} if finding.variant else {}),
        "explanation": finding.explanation,
        "confidence": round(finding.confidence, 3),
        "parameters": {
            name: {"value": _digits(each.value), "ci95": [_digits(each.low), _digits(each.high)], "unit": each.unit}
            for name, each in finding.parameters.items()
        },
        "equivalent_to": list(finding.equivalent_to),
        "next_experiment": finding.next_experiment,
        "evidence": {name: _digits(getattr(finding, name)) for name in ("gain", "share", "rest")},
        "alternatives": [{"mechanism": name, "gain": _digits(gain)} for name, gain in finding.alternatives],
    }


def _digits(value: float) -> float:
    return float(f"{value:.6g}")
