"""The set-point is held."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.corners import Corners


@dataclass(frozen=True)
class Steady:
    """``w = top`` (CONTRACTS.md, section 1)."""

    word: ClassVar[str] = "steady"
    length: ClassVar[float] = inf

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]."""
        return np.full(time.shape, top)

    def load(self, time: NDArray[np.float64]) -> None:
        """Return None: the load is the rig's."""

    def corners(self, *, top: float, duration: float) -> Corners:
        """Return one straight line."""
        return Corners(time=(0.0, duration), speed=(top, top))
