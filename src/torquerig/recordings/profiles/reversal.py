"""Reversal: two sine periods of speed, both directions."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.breakpoints import Breakpoints

LINES = 400  # straight lines for two periods: off the sine by 1.2e-4 of the set-point at most


@dataclass(frozen=True)
class Reversal:
    """``w = top sin(4 pi t / duration)`` (CONTRACTS.md, section 1)."""

    name: ClassVar[str] = "reversal"
    length: ClassVar[float] = inf

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]."""
        return np.asarray(top * np.sin(4 * np.pi * time / duration))

    def load(self, time: NDArray[np.float64]) -> None:
        """Return None: the load is the rig's."""

    def breakpoints(self, *, top: float, duration: float) -> Breakpoints:
        """Return the two periods as straight lines."""
        time = np.linspace(0.0, duration, LINES + 1)
        speed = self.speed(time, top=top, duration=duration)
        speed[:: LINES // 4] = 0.0  # exact zeros where the sine crosses zero
        return Breakpoints(time=tuple(time.tolist()), speed=tuple(speed.tolist()))
