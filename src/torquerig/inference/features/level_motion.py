"""Speed and acceleration of the motor within each part whose mean torque is a level."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.measured_run import MeasuredRun

Floats = NDArray[np.float64]

POINTS = 9  # moments of a part at which the motion is kept
_SHORTEST_SLOPE = 8  # samples of a part that has a slope


def level_motion(run: MeasuredRun, parts: NDArray[np.int64]) -> tuple[Floats, Floats]:
    """Return speed [rad/s] and acceleration [rad/s^2] of the motor at some moments of each part, (levels, POINTS).

    The acceleration is the slope over each half of the part by least squares; 0 in a steady run, where it would be the
    noise of the encoder.
    """
    speeds = np.zeros((len(parts), POINTS))
    slopes = np.zeros((len(parts), POINTS))
    for row, (low, high) in enumerate(parts.tolist()):
        speed = run.speed[low:high]
        speeds[row] = speed[np.linspace(0, speed.size - 1, POINTS).astype(int)]
        if not run.is_steady and speed.size > _SHORTEST_SLOPE:
            for half, own in zip(np.array_split(speed, 2), np.array_split(slopes[row], 2), strict=True):
                time = np.linspace(-0.5, 0.5, half.size)
                own[:] = float(half @ time) / float(time @ time) * run.rate / half.size
    return speeds, slopes
