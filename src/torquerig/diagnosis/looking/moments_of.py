"""From flags to moments: where something goes on for one sample or more."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.inspection.runs import runs_of


def moments_of(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first one and one past the last of each run of True."""
    return [(first, first + length) for first, length in runs_of(np.ascontiguousarray(flags, dtype=bool))]
