"""A long curve drawn with few points: the lowest and the highest value of each column of pixels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def envelope(x: Array, y: Array, *, columns: int = 900, logarithmic: bool = False) -> tuple[Array, Array]:
    """Return at most two points per column, so that no peak is lost; short curves come back as they are.

    Parameters
    ----------
    x, y : ndarray, shape (points,)
        ``x`` ascending, and above 0 where ``logarithmic``.
    columns : int
        How many columns of equal width (of equal ratio where ``logarithmic``) the picture has.
    """
    if x.size <= 2 * columns:
        return x, y
    place = np.log(x) if logarithmic else x
    column = np.minimum(((place - place[0]) / (place[-1] - place[0]) * columns).astype(int), columns - 1)
    starts = np.flatnonzero(np.diff(column, prepend=-1))
    kept: list[int] = []
    for first, end in zip(starts.tolist(), [*starts[1:].tolist(), x.size], strict=True):
        part = y[first:end]
        kept += sorted({first + int(part.argmin()), first + int(part.argmax())})
    return x[kept], y[kept]
