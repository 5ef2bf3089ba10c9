"""Numbers of an answer: digits, and fitted parameters with their intervals."""

from __future__ import annotations

from typing import Any

import numpy as np

from torquerig.inference.fit import Fit
from torquerig.inference.knobs import within

MOST_SURE = 0.99  # no set of hypotheses is complete
TWO_SIDED = 1.96  # standard deviations of half a 95 % interval


def digits(value: float) -> float:
    """Return a number with six digits, as all numbers of an answer have."""
    return float(f"{value:.6g}")


def estimate(fit: Fit, column: int, unit: str) -> dict[str, Any]:
    """Return a fitted parameter with its 95 % interval, by the covariance of the posterior."""
    knob, position = fit.knobs[column], float(fit.positions[column])
    half = TWO_SIDED * float(np.sqrt(fit.covariance()[column, column]))
    part, median = fit.rig.part(knob.part), knob.value(fit.rig)
    low, value, high = (within(part, knob.field, knob.turned(median, position + way * half)) for way in (-1, 0, 1))
    ends = sorted((low, high))
    return {"value": digits(value), "ci95": [digits(end) for end in ends], "unit": unit}
