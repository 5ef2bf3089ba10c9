"""The samples of a curve as text for a page: 16-bit steps, compressed."""

from __future__ import annotations

import gzip
from base64 import b64encode
from typing import Any

import numpy as np
from numpy.typing import NDArray

STEPS = 65_535  # of the curve's span: finer than the 16-bit converter that recorded it
ROUNDING = 1e-9  # [1] of the span: two values nearer than this are one code
NEAR = 1e-3  # [1] of a step: values of a converter are this near to a multiple of it


def packed_curve(values: NDArray[np.float64], *, start: float, step: float, coarsest: float = 0.0) -> dict[str, Any]:
    """Return a curve with equal steps in x for ``unpackCurve`` of the page; each value is off by half a step at most.

    A curve whose values are codes of a converter keeps its exact values.

    Parameters
    ----------
    values : ndarray, shape (samples,)
        Finite, in the unit of the plot.
    start, step : float
        x of the first sample, and between two samples.
    coarsest : float
        Size of a step that is fine enough; larger than that of 16 bit, it saves space.
    """
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    size = converter_step(values) or max((high - low) / STEPS, coarsest) or 1.0
    codes = np.round((values - low) / size).astype(np.int32)
    # differences of neighbours, small of either sign: 0, -1, 1, -2 as 0, 1, 2, 3; then all low bytes, all high bytes
    steps = np.diff(codes, prepend=0).astype(np.int16)
    signless = ((steps.astype(np.int32) << 1) ^ (steps.astype(np.int32) >> 15)).astype(np.uint16)
    planes = (signless & 0xFF).astype(np.uint8).tobytes() + (signless >> 8).astype(np.uint8).tobytes()
    packed = gzip.compress(planes, compresslevel=9, mtime=0)
    return {
        "samples": int(values.size), "low": low, "size": size, "start": start, "step": step,
        "packed": b64encode(packed).decode(),
    }  # fmt: skip


def converter_step(values: NDArray[np.float64]) -> float:
    """Return the step of which all values are a multiple apart, as a converter of at most 16 bit gives them; else 0."""
    levels = np.unique(values)
    if not 2 < levels.size <= STEPS:
        return 0.0
    span, steps = float(levels[-1] - levels[0]), np.diff(levels)
    least = float(steps[steps > ROUNDING * span].min(initial=np.inf))
    if span / least > STEPS:
        return 0.0
    count = round(span / least)
    places = (levels - levels[0]) * (count / span)
    return span / count if float(np.abs(places - np.round(places)).max()) < NEAR else 0.0
