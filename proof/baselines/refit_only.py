"""Baseline that fits parameters only: it tests for a significant residual and names no mechanism."""

from __future__ import annotations

from typing import Any

from proof.baselines.verdict import verdict
from torquerig.diagnosis.engine import Outcome
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.outcome import METRIC


def refit_only(outcome: Outcome) -> dict[str, Any]:
    """Return ``adequate`` if the calibrated nominal model has no significant residual, else ``unexplained``."""
    left, misfit = mismatches(outcome.before), outcome.diagnosis.fit.before
    return verdict("unexplained" if left else "adequate", outcome, metric=METRIC, before=misfit, after=misfit)
