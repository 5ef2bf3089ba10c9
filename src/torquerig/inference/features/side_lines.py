"""Where a line may have side lines: about its frequency and about its first multiples."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_BESIDE, _MULTIPLES = 0.5, 3  # [1] of a line's frequency: how far side lines reach, also from its multiples


def may_be_beside(line: Floats, other: Floats) -> NDArray[np.bool_]:
    """Return whether lines [Hz], (segments, lines), may have side lines at others, shape (segments, lines, others)."""
    multiple = other[:, None, :] / np.maximum(line, 1e-9)[:, :, None]
    nearest = np.clip(np.rint(multiple), 1, _MULTIPLES)
    return np.asarray(np.abs(multiple - nearest) < _BESIDE)
