"""The samples of a curve as text for a page: 16-bit steps, compressed."""

from __future__ import annotations

import gzip
from base64 import b64encode
from typing import Any

import numpy as np
from numpy.typing import NDArray

STEPS = 65_535  # of the curve's span: finer than the 16-bit converter that recorded it


def packed_curve(values: NDArray[np.float64], *, start: float, step: float, coarsest: float = 0.0) -> dict[str, Any]:
    """Return a curve with equal steps in x for ``unpackCurve`` of the page; each value is off by half a step at most.

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
    size = max((high - low) / STEPS, coarsest) or 1.0
    codes = np.round((values - low) / size).astype(np.int32)
    # differences of neighbours compress to a third; they wrap around in 16 bit and add up again
    wrapped = np.diff(codes, prepend=0).astype(np.uint16).astype("<u2")
    packed = gzip.compress(wrapped.tobytes(), compresslevel=9, mtime=0)
    return {
        "samples": int(values.size), "low": low, "size": size, "start": start, "step": step,
        "packed": b64encode(packed).decode(),
    }  # fmt: skip
