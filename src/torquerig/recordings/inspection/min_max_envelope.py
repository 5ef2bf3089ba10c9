"""The lowest and the highest value over time, for the picture of a long signal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

COLUMNS = 2000


@dataclass(frozen=True, kw_only=True)
class MinMaxEnvelope:
    """Extremes of columns of ``width`` samples each, shape (columns,), from sample 0; NaN where there is no number."""

    width: int
    low: NDArray[np.float64]
    high: NDArray[np.float64]

    def centres(self) -> NDArray[np.float64]:
        """Return the sample number of the middle of each column."""
        return np.asarray((np.arange(self.low.size) + 0.5) * self.width, dtype=np.float64)


def envelope_of(values: NDArray[np.float64], *, width: int) -> MinMaxEnvelope:
    """Return the extremes of ``values``, shape (samples,), in columns of ``width`` samples, the last one shorter."""
    starts = np.arange(0, values.size, width)
    with np.errstate(invalid="ignore"):
        return MinMaxEnvelope(width=width, low=np.fmin.reduceat(values, starts), high=np.fmax.reduceat(values, starts))


def joined_envelopes(left: MinMaxEnvelope, right: MinMaxEnvelope) -> MinMaxEnvelope:
    """Return the envelope of both, of 4000 columns at most; all columns but the last are equally wide."""
    low, high = np.concatenate([left.low, right.low]), np.concatenate([left.high, right.high])
    return thinned(MinMaxEnvelope(width=left.width, low=low, high=high))


def thinned(envelope: MinMaxEnvelope) -> MinMaxEnvelope:
    """Return the envelope with pairs of columns merged until there are at most 4000."""
    while envelope.low.size > 2 * COLUMNS:
        starts = np.arange(0, envelope.low.size, 2)
        envelope = MinMaxEnvelope(
            width=2 * envelope.width,
            low=np.fmin.reduceat(envelope.low, starts),
            high=np.fmax.reduceat(envelope.high, starts),
        )
    return envelope
