"""What an effect of the slow torque must gain beside steps of the mean: one that was not seen looks like it."""

from __future__ import annotations

from torquerig.diagnosis.case import Case

_BESIDE_STEPS = 300.0


def price_beside_steps(case: Case) -> float:
    """Return the price of a drift or a friction, 0 where the mean of no run steps, nor jumps between two levels."""
    return _BESIDE_STEPS if any(run.stepping for run in case.runs) else 0.0
