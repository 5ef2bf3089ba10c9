"""From a tenth of the set-point up to it, then held."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.corners import Corners


@dataclass(frozen=True)
class Ramp:
    """``w = top min(0.1 + t / duration, 1)``: held for the last tenth (CONTRACTS.md, section 1)."""

    word: ClassVar[str] = "ramp"
    length: ClassVar[float] = inf

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]."""
        return np.asarray(top * np.minimum(0.1 + time / duration, 1.0))

    def load(self, time: NDArray[np.float64]) -> None:
        """Return None: the load is the rig's."""

    def corners(self, *, top: float, duration: float) -> Corners:
        """Return the rise and the hold."""
        return Corners(time=(0.0, 0.9 * duration, duration), speed=(0.1 * top, top, top))
