"""What a diagnosis says, read from its JSON in the form of the contract."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.errors import ProofError

VERDICTS = ("adequate", "missing_physics", "unexplained", "setup_error")
DOMAIN_OF_KIND = {"line_family": "order", "tone": "frequency", "resonance": "frequency", "level_course": "time",
                  "gain_course": "time"}  # fmt: skip


@dataclass(frozen=True)
class Estimate:
    """A value with its 95 % interval, each None where not given."""

    value: float | None
    interval: tuple[float, float] | None


@dataclass(frozen=True)
class Named:
    """A finding or a set-up fact: its name or kind, confidence, part, alternatives and parameters."""

    name: str
    confidence: float
    part: str
    equivalent_to: tuple[str, ...]
    parameters: Mapping[str, Estimate]


@dataclass(frozen=True)
class Located:
    """A place that a diagnosis reports: domain, axis, positions (with harmonics), relative width, and whether minor."""

    domain: str
    axis: str
    positions: tuple[float, ...]
    width: float
    minor: bool = False


@dataclass(frozen=True)
class Claim:
    """The diagnosis of one case.

    ``before`` and ``after`` are the mean squared standardised residuals on held-out data; ``rms_before`` and
    ``rms_after`` the rms errors in N m, None where the diagnosis does not report them.
    """

    verdict: str
    findings: tuple[Named, ...] = ()
    setup: tuple[Named, ...] = ()
    places: tuple[Located, ...] = ()
    before: float | None = None
    after: float | None = None
    rms_before: float | None = None
    rms_after: float | None = None


def read_claim(path: Path) -> Claim:
    """Return the claim of a diagnosis file.

    Raises
    ------
    ProofError
        If the file is not a diagnosis in the form of the contract.
    """
    try:
        return claim_of(json.loads(path.read_text(encoding="utf-8")))
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as wrong:
        raise ProofError(f"{path}: the file is not a diagnosis in the form of the contract ({wrong!r})") from wrong


def claim_of(data: Mapping[str, Any]) -> Claim:
    """Return what a diagnosis says."""
    if data["verdict"] not in VERDICTS:
        raise ValueError(f"verdict {data['verdict']!r}")
    fit, rms = data.get("fit") or {}, data.get("rms") or {}
    places = [*map(_unnamed, data.get("unnamed") or ()), *map(_mismatch, data.get("mismatch") or ())]
    return Claim(
        verdict=data["verdict"],
        findings=tuple(_named(row, row["mechanism"]) for row in data.get("findings") or ()),
        setup=tuple(_fact(row) for row in data.get("setup") or ()),
        places=tuple(one for one in places if one is not None),
        before=(fit.get("before") or {}).get("heldout_misfit"),
        after=(fit.get("after") or {}).get("heldout_misfit"),
        rms_before=rms.get("before"),
        rms_after=rms.get("after"),
    )


def _named(row: Mapping[str, Any], name: str) -> Named:
    parameters = {key: _estimate(one) for key, one in (row.get("parameters") or {}).items()}
    return Named(name, float(row["confidence"]), str(row.get("part") or ""), _alternatives(row), parameters)


def _fact(row: Mapping[str, Any]) -> Named:
    estimated = {"estimated": _estimate(row.get("estimated") or {})}
    return Named(row["kind"], float(row["confidence"]), str(row.get("of") or ""), _alternatives(row), estimated)


def _alternatives(row: Mapping[str, Any]) -> tuple[str, ...]:
    return tuple(
        one if isinstance(one, str) else str(one.get("mechanism", one.get("kind", "")))
        for one in row.get("equivalent_to") or ()
    )


def _estimate(row: Mapping[str, Any]) -> Estimate:
    value: Any = row.get("value")
    low, high = row.get("ci95") or (None, None)
    pair = None if low is None or high is None else (float(low), float(high))
    return Estimate(None if value is None else float(value), pair)


def _unnamed(row: Mapping[str, Any]) -> Located | None:
    if row.get("at") is None:
        return None
    at = float(row["at"])
    of_axis = {"Hz": "frequency", "rpm": "speed"}.get(str(row.get("axis")), "time")
    domain = "speed" if of_axis == "speed" else DOMAIN_OF_KIND.get(row["kind"], of_axis)
    multiples = row.get("harmonics") or [1]
    return Located(
        domain, str(row.get("axis") or ""), tuple(at * float(one) for one in multiples), 0.0, bool(row.get("minor"))
    )


def _mismatch(row: Mapping[str, Any]) -> Located | None:
    at = row.get("at")
    if at is None:
        return None
    width = abs(float(row.get("width") or 0.0)) / max(abs(float(at)), 1e-12)
    return Located(row["domain"], str(row.get("axis") or ""), (float(at),), width)
