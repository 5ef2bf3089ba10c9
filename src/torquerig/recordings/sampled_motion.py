"""A measured motion on the samples of its recording, and its low-pass."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.replay import ReplayedMotion

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SampledMotion:
    """A motion that every simulation of its run requires again; ``zero`` is added to the position [rad] or [m]."""

    curve: ReplayedMotion
    time: Floats
    angle: Floats
    speed: Floats
    zero: float = 0.0

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Return angle and speed at equally spaced times [s]; InputError where they go beyond the recording."""
        if time.size == self.time.size and np.array_equal(time, self.time):
            return self.angle + self.zero, self.speed
        angle, speed = self.curve.at(time)
        return angle + self.zero, speed


def low_passed(values: Floats, band: float) -> Floats:
    """Return a signal below ``band`` of its sample rate, without delay (Butterworth, fourth order, both ways)."""
    from scipy.signal import butter, sosfiltfilt

    return np.asarray(sosfiltfilt(butter(4, 2 * band, output="sos"), values))
