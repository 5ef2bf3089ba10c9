"""Where a line may stand: at an order of the motor shaft, or at a fixed frequency."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import Literal

import numpy as np
from numpy.typing import NDArray

SAME_ORDER = 0.006  # [1/rev of the motor] two orders nearer than this are one
WHOLE_ORDER = 0.004  # [1/rev of the motor] so near to a whole order of a shaft a line is taken to stand on it
RESOLVED = 0.7  # two lines nearer than this many bins of a stretch are one line to it
RESOLVED_WELL = 1.3  # the same in steady runs whose angle was not measured, and where lines are still looked for


@dataclass(frozen=True, order=True)
class Place:
    """``at`` is a motor order [1/rev] or a frequency [Hz]."""

    domain: Literal["order", "frequency"]
    at: float

    def frequency(self, speed: float) -> float:
        """Return where the line stands [Hz] while the motor turns at ``speed`` [rad/s]."""
        return self.at * abs(speed) / (2 * pi) if self.domain == "order" else self.at

    def phase(self, angle: NDArray[np.float64], time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the phase of the line [rad] over the motor's angle [rad] and the time [s]."""
        return self.at * angle if self.domain == "order" else 2 * pi * self.at * time


def order(at: float) -> Place:
    """Return the place of a motor order, rounded so that equal orders are equal."""
    return Place("order", float(f"{at:.9g}"))


def frequency(at: float) -> Place:
    """Return the place of a fixed frequency [Hz]."""
    return Place("frequency", float(f"{at:.9g}"))
