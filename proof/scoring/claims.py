"""What does a diagnosis say? Read from its JSON as the contract has it, and no further than it is scored."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.errors import ProofError

VERDICTS = ("adequate", "missing_physics", "unexplained")


@dataclass(frozen=True)
class Estimate:
    """One parameter of a finding with its 95 % interval, or none."""

    value: float | None
    interval: tuple[float, float] | None


@dataclass(frozen=True)
class Finding:
    """One mechanism that a diagnosis names."""

    mechanism: str
    confidence: float
    equivalent_to: tuple[str, ...] = ()
    parameters: tuple[tuple[str, Estimate], ...] = ()
    next_experiment: str | None = None


@dataclass(frozen=True)
class Claim:
    """What a diagnosis says of one case; misfits are on data that no fit has seen."""

    verdict: str
    findings: tuple[Finding, ...] = ()
    before: float | None = None
    after: float | None = None


def read_claim(path: Path) -> Claim:
    """Read one diagnosis.

    Raises
    ------
    ProofError
        If it is no diagnosis of the contract's kind; the file and the key are named.
    """
    try:
        return claim_of(json.loads(path.read_text(encoding="utf-8")))
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as wrong:
        raise ProofError(f"{path}: not a diagnosis of the contract's kind ({wrong!r})") from wrong


def claim_of(text: dict[str, Any]) -> Claim:
    """Take what is scored out of a diagnosis."""
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
    """Read one finding."""
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
