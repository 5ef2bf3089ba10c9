"""The verdict of a baseline in the form of a diagnosis, for the same scoring."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from proof.baselines.calibrated import Calibrated
from torquerig.inference.answer.document import SCHEMA


@dataclass(frozen=True, kw_only=True)
class Named:
    """One finding of a baseline; ``parameters`` by the contract's name, without intervals."""

    mechanism: str
    confidence: float
    explanation: str
    parameters: Mapping[str, float] = field(default_factory=dict)


def verdict(
    word: str, start: Calibrated, named: Sequence[Named] = (), *, metric: str = "", before: float | None = None,
    after: float | None = None,
) -> dict[str, Any]:  # fmt: skip
    """Return the JSON of a verdict, with residuals if the baseline has a model."""
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
            "metric": metric or "None: this baseline has no model.",
            "before": {"heldout_misfit": before, "nominal": None},
            "after": {"heldout_misfit": after},
            "improvement": None,
        },
        "model": None,
        "recordings": start.diagnosis["recordings"],
    }
