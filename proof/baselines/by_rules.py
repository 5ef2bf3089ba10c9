"""The calibrated nominal model by the first engine."""

from __future__ import annotations

from typing import Any

from proof.baselines.calibrated import Calibrated, CalibratedRun
from torquerig.diagnosis.engine import Outcome


def by_rules(outcome: Outcome, diagnosis: dict[str, Any]) -> Calibrated:
    """Return the model before anything was added to it, from a diagnosis by the first engine."""
    runs = tuple(
        CalibratedRun(
            rate=run.rate, torque=run.torque, angle=run.angle, speed=run.speed, steady=run.steady,
            held=run.mask(held=True),
        )
        for run in outcome.before.runs
    )  # fmt: skip
    return Calibrated(runs=runs, nominal=outcome.before.nominal, rig=outcome.before.model.rig, diagnosis=diagnosis)
