"""Baseline that fits parameters only: it tests for a significant residual and names no mechanism."""

from __future__ import annotations

from typing import Any

from proof.baselines.calibrated import Calibrated
from proof.baselines.verdict import verdict


def refit_only(start: Calibrated) -> dict[str, Any]:
    """Return ``adequate`` if the calibrated nominal model has no significant residual, else ``unexplained``."""
    fit = start.diagnosis["fit"]
    residual = fit["before"]["heldout_misfit"]
    word = "unexplained" if start.diagnosis["mismatch"] else "adequate"
    return verdict(word, start, metric=fit["metric"], before=residual, after=residual)
