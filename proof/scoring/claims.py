"""The scored parts of a diagnosis, read from its JSON in the form of the contract."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.errors import ProofError

VERDICTS = ("adequate", "missing_physics", "unexplained")


@dataclass(frozen=True)
class Estimate:
    """One parameter of a finding with its 95 % interval, or None."""

    value: float | None
    interval: tuple[float, float] | None


@dataclass(frozen=True)
class Finding:
    """One finding of a diagnosis."""

    mechanism: str
    confidence: float
    equivalent_to: tuple[str, ...] = ()
    parameters: tuple[tuple[str, Estimate], ...] = ()
    next_experiment: str | None = None


@dataclass(frozen=True)
class Claim:
    """The diagnosis of one case; ``before`` and ``after`` are held-out residuals."""

    verdict: str
    findings: tuple[Finding, ...] = ()
    before: float | None = None
    after: float | None = None


def read_claim(path: Path) -> Claim:
    """Return the claim of one diagnosis file.

    Raises
    ------
    ProofError
        If the file is not a diagnosis in the form of the contract; it names the file and the key.
    """
    try:
        return claim_of(json.loads(path.read_text(encoding="utf-8")))
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as wrong:
        raise ProofError(f"{path}: the file is not a diagnosis in the form of the contract ({wrong!r})") from wrong


def claim_of(text: dict[str, Any]) -> Claim:
    """Return the scored parts of a diagnosis."""
    if text["verdict"] not in VERDICTS:
        raise ValueError(f"verdict {text['verdict']!r}")
    fit = text.get("fit") or {}
    return Claim(
        verdict=text["verdict"],
        findings=tuple(_finding(row) for row in text.get("findings", [])),
        before=(fit.get("before") or {}).get("heldout_misfit"),
        after=(fit.get("after") or {}).get("heldout_misfit"),
    )


def _finding(row: dict[str, Any]) -> Finding:
    """Return one finding."""
    parameters = []
    for name, stated in (row.get("parameters") or {}).items():
        value, interval = stated.get("value"), stated.get("ci95")
        pair = None if interval is None or None in interval else (float(interval[0]), float(interval[1]))
        parameters.append((name, Estimate(None if value is None else float(value), pair)))
    return Finding(
        mechanism=row["mechanism"],
        confidence=float(row["confidence"]),
        equivalent_to=tuple(row.get("equivalent_to") or ()),
        parameters=tuple(parameters),
        next_experiment=row.get("next_experiment"),
    )
