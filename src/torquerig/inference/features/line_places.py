"""Which lines a block can show: fast enough, below half the sample rate, and separate from each other."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.places import Place

Floats = NDArray[np.float64]

FEWEST_PERIODS = 3.0  # of a line within a block: fewer cannot be separated from level, slope and slower lines
FEWEST_SWEPT = 5.0  # the same where the speed changes: the level then has a curve too
_CHANGES = 0.01  # [1] of the speed within a block: less is no change
HIGHEST = 0.45  # of the sample rate: higher up, filters against aliasing differ from converter to converter
HIGHEST_TONE = 0.49  # of the sample rate: a tone is as large as it is read, whatever a filter leaves of it
SEPARATE = 1.3  # [bins of a block] two lines under a Hann window that are nearer are one


def line_frequencies(places: Sequence[Place], speed: Floats | float) -> Floats:
    """Return the frequency of each place [Hz] at motor speeds [rad/s], shape (speeds, places)."""
    at = np.array([place.at for place in places])
    turning = np.array([place.domain == "order" for place in places], dtype=bool)
    revolutions = np.abs(np.atleast_1d(np.asarray(speed, dtype=float)))[:, None] / (2 * pi)
    return np.asarray(np.where(turning, at * revolutions, at))


def shown_places(places: Sequence[Place], speed: Floats, rate: float) -> list[int]:
    """Return the indices of the places that a block shows, of two that are not separate the first one.

    ``speed`` is that of the motor along the block [rad/s], shape (samples,).
    """
    duration = speed.size / rate
    mean = line_frequencies(places, float(speed.mean()))[0]
    fastest = line_frequencies(places, float(np.abs(speed).max()))[0]
    swept = float(speed.max() - speed.min()) > _CHANGES * float(np.abs(speed).max())
    highest = rate * np.array([HIGHEST if place.domain == "order" else HIGHEST_TONE for place in places])
    permitted = (mean * duration >= (FEWEST_SWEPT if swept else FEWEST_PERIODS)) & (fastest < highest)
    shown: list[int] = []
    for index in np.flatnonzero(permitted).tolist():
        if not shown or np.abs(mean[shown] - mean[index]).min() * duration >= SEPARATE:
            shown.append(index)
    return shown
