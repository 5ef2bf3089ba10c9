"""The verdict of a baseline in the form of a diagnosis, so that the same scoring applies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.outcome import SCHEMA


@dataclass(frozen=True, kw_only=True)
class Named:
    """One mechanism that a baseline names; ``parameters`` by the contract's name, without intervals."""

    mechanism: str
    confidence: float
    explanation: str
    parameters: Mapping[str, float] = field(default_factory=dict)


def verdict(
    word: str, outcome: Outcome, named: Sequence[Named] = (), *, metric: str = "", before: float | None = None,
    after: float | None = None,
) -> dict[str, Any]:  # fmt: skip
    """Return the JSON of a verdict; misfits are given where the baseline has a model of its own to be judged."""
    return {
        "schema": SCHEMA,
        "verdict": word,
        "mismatch": [],
        "findings": [
            {
                "mechanism": one.mechanism,
                "explanation": one.explanation,
                "confidence": round(one.confidence, 3),
                "parameters": {name: {"value": value, "ci95": None} for name, value in one.parameters.items()},
                "equivalent_to": [],
                "next_experiment": None,
            }
            for one in named
        ],
        "fit": {
            "metric": metric or "none: this baseline makes no model",
            "before": {"heldout_misfit": before, "nominal": None},
            "after": {"heldout_misfit": after},
            "improvement": None,
        },
        "model": None,
        "recordings": [
            {"file": one.file, "speed_rpm": one.speed_rpm, "used_for": one.used_for}
            for one in outcome.diagnosis.recordings
        ],
    }
