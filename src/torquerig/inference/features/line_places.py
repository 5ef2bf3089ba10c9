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
RESOLVED = 2.0  # [bins] half the width of a line under a Hann window; one smeared by less is fitted by regression


def line_frequencies(places: Sequence[Place], speed: Floats | float) -> Floats:
    """Return the frequency of each place [Hz] at motor speeds [rad/s], shape (speeds, places)."""
    at = np.array([place.at for place in places])
    turning = np.array([place.domain == "order" for place in places], dtype=bool)
    revolutions = np.abs(np.atleast_1d(np.asarray(speed, dtype=float)))[:, None] / (2 * pi)
    return np.asarray(np.where(turning, at * revolutions, at))


def smeared_width(places: Sequence[Place], frequency: Floats, smearing: float, duration: float) -> Floats:
    """Return half the widths over which lines are smeared [Hz], shape (places,); zero of those as sharp as a tone.

    ``frequency`` [Hz] has the shape (places,), ``smearing`` is relative to it [1], ``duration`` that of the block [s].
    """
    turning = np.array([place.domain == "order" for place in places], dtype=bool)
    width = np.where(turning, smearing * frequency, 0.0)
    return np.where(width * duration > RESOLVED, width, 0.0)


def shown_places(places: Sequence[Place], speed: Floats, rate: float, *, smearing: float = 0.0) -> list[int]:
    """Return the indices of the places that a block shows, of two that are not separate the first one.

    ``speed`` is that of the motor along the block [rad/s], shape (samples,), ``smearing`` the relative width of lines
    whose angle was not measured [1]: of two that are smeared into each other the power is that of both.
    """
    duration = speed.size / rate
    mean = line_frequencies(places, float(speed.mean()))[0]
    fastest = line_frequencies(places, float(np.abs(speed).max()))[0]
    swept = float(speed.max() - speed.min()) > _CHANGES * float(np.abs(speed).max())
    highest = rate * np.array([HIGHEST if place.domain == "order" else HIGHEST_TONE for place in places])
    permitted = (mean * duration >= (FEWEST_SWEPT if swept else FEWEST_PERIODS)) & (fastest < highest)
    width = smeared_width(places, mean, smearing, duration)
    shown: list[int] = []
    for index in np.flatnonzero(permitted).tolist():
        both = np.where((width[shown] > 0) & (width[index] > 0), width[shown] + width[index], SEPARATE / duration)
        if (np.abs(mean[shown] - mean[index]) >= both).all():
            shown.append(index)
    return shown
