"""Ramp: from a tenth of the set-point to all of it, then constant."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.breakpoints import Breakpoints


@dataclass(frozen=True)
class Ramp:
    """``w = top min(0.1 + t / duration, 1)``: held for the last tenth (CONTRACTS.md, section 1)."""

    name: ClassVar[str] = "ramp"
    length: ClassVar[float] = inf

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]."""
        return np.asarray(top * np.minimum(0.1 + time / duration, 1.0))

    def load(self, time: NDArray[np.float64]) -> None:
        """Return None: the load is the rig's."""

    def breakpoints(self, *, top: float, duration: float) -> Breakpoints:
        """Return the ramp and the constant part."""
        return Breakpoints(time=(0.0, 0.9 * duration, duration), speed=(0.1 * top, top, top))
