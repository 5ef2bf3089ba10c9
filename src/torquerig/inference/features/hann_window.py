"""The window of lines and bands; a run has many blocks of few lengths."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

_KEPT = 8  # lengths


@lru_cache(maxsize=_KEPT)
def hann_window(count: int) -> NDArray[np.float64]:
    """Return a Hann window of so many samples, 0 at both ends; it is shared and cannot be written to."""
    window = np.hanning(count)
    window.flags.writeable = False
    return window
