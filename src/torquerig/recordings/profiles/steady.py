"""Steady: a constant set-point."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.breakpoints import Breakpoints


@dataclass(frozen=True)
class Steady:
    """``w = top`` (CONTRACTS.md, section 1)."""

    name: ClassVar[str] = "steady"
    length: ClassVar[float] = inf

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]."""
        return np.full(time.shape, top)

    def load(self, time: NDArray[np.float64]) -> None:
        """Return None: the load is the rig's."""

    def breakpoints(self, *, top: float, duration: float) -> Breakpoints:
        """Return one straight line."""
        return Breakpoints(time=(0.0, duration), speed=(top, top))
