"""A histogram whose range grows with the blocks of a recording."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, floor, log2

import numpy as np
from numpy.typing import NDArray

_MOST = 400


@dataclass(frozen=True, kw_only=True)
class Histogram:
    """Counts, shape (bins,), of levels from ``first * width`` on; ``width`` is a power of two."""

    width: float
    first: int
    counts: NDArray[np.int64]

    def edges(self) -> NDArray[np.float64]:
        """Return the edges of the bins, shape (bins + 1,)."""
        return np.asarray((self.first + np.arange(self.counts.size + 1)) * self.width, dtype=np.float64)


def histogram_of(values: NDArray[np.float64]) -> Histogram | None:
    """Return the histogram of finite ``values``, of 200 to 400 bins; None where there are none."""
    if values.size == 0:
        return None
    low, high = float(values.min()), float(values.max())
    span = (high - low) or max(abs(high), 1.0) * 1e-3
    width = 2.0 ** ceil(log2(span / _MOST * 1.01))
    first = floor(low / width)
    counts = np.bincount((np.floor(values / width) - first).astype(np.int64))
    return Histogram(width=width, first=first, counts=counts)


def joined_histograms(left: Histogram | None, right: Histogram | None) -> Histogram | None:
    """Return the histogram of both, with bins doubled in width until there are at most 400."""
    if left is None or right is None:
        return left or right
    width = max(left.width, right.width)
    while True:
        parts = [_coarser(one, width) for one in (left, right)]
        first = min(one.first for one in parts)
        size = max(one.first + one.counts.size for one in parts) - first
        if size <= _MOST:
            break
        width *= 2
    counts = np.zeros(size, dtype=np.int64)
    for one in parts:
        counts[one.first - first :][: one.counts.size] += one.counts
    return Histogram(width=width, first=first, counts=counts)


def _coarser(histogram: Histogram, width: float) -> Histogram:
    if width == histogram.width:
        return histogram
    factor = round(width / histogram.width)
    places = np.floor_divide(histogram.first + np.arange(histogram.counts.size), factor)
    first = int(places[0])
    counts = np.bincount(places - first, weights=histogram.counts).astype(np.int64)
    return Histogram(width=width, first=first, counts=counts)
