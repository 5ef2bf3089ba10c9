"""Modes rung by impacts: a comb of lines as far as impacts keep their rhythm over a block, noise beyond.

Where the angle between impacts varies by the relative standard deviation s, line k of the comb of N impacts keeps the
share ``exp(-(2 pi k s)^2 N / 4)`` of its power: a random walk of the phase, in its middle half as wide as at its end.
"""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.linear.twin import Twin
from torquerig.inference.features.run_features import RunFeatures
from torquerig.sensor_stages.ringing import Ringing

Floats = NDArray[np.float64]

_MOST_LINES = 400  # of a comb
_HIGHEST = 0.45  # of the sample rate


def ringing_density(twin: Twin, seen: RunFeatures) -> Floats:
    """Return the density that rung modes leave next to the lines of their combs [(N m)^2/Hz], (segments, bands)."""
    bands = seen.bands
    answer = np.zeros((len(seen.segments), bands.low.size))
    for stage in _ringing(twin):
        for row, rate in enumerate(_impacts(stage, seen).tolist()):
            if rate > 0:
                power = stage.density_between(bands.low, bands.high, rate) * twin.amplifier_power(bands.middle)
                answer[row] += power * (1 - _in_rhythm(stage, seen, row, bands.middle / rate))
    return answer


def ringing_lines(twin: Twin, seen: RunFeatures) -> tuple[Floats, Floats]:
    """Return frequencies [Hz] and amplitudes [N m] of the lines of the combs, shape (lines, segments)."""
    frequency, amplitude = list[Floats](), list[Floats]()
    for stage in _ringing(twin):
        rate = _impacts(stage, seen)
        slowest = float(rate[rate > 0].min(initial=np.inf))
        count = min(int(_HIGHEST * seen.run.rate / slowest), _MOST_LINES)
        multiple = np.arange(1.0, count + 1)[:, None]
        at = multiple * rate[None]
        share = np.column_stack([_in_rhythm(stage, seen, row, multiple[:, 0]) for row in range(rate.size)])
        # a line of amplitude a has the power a^2 / 2, which is the density times the distance of two lines
        power = np.column_stack([2 * each * stage.density(at[:, row], each) for row, each in enumerate(rate.tolist())])
        kept = (share > 0).any(axis=1)
        frequency.append(at[kept])
        amplitude.append(np.sqrt(share * power * twin.amplifier_power(at))[kept])
    if not frequency:
        return np.zeros((0, len(seen.segments))), np.zeros((0, len(seen.segments)))
    return np.concatenate(frequency), np.concatenate(amplitude)


def _ringing(twin: Twin) -> list[Ringing]:
    return [stage for stage in twin.rig.stages() if isinstance(stage, Ringing)]


def _impacts(stage: Ringing, seen: RunFeatures) -> Floats:
    """Return the impacts per second in each segment."""
    return np.asarray(stage.order * stage.turns * np.abs(seen.speed) / (2 * pi))


def _in_rhythm(stage: Ringing, seen: RunFeatures, row: int, multiple: Floats) -> Floats:
    """Return the share of the power that lines of the comb keep in a segment [1]; less than a millionth is none."""
    segment = seen.segments[row]
    number = float(_impacts(stage, seen)[row]) * seen.duration_of(segment)
    share = np.exp(-((2 * pi * multiple * stage.slip) ** 2) * number / 4)
    return np.where(share > 1e-6, share, 0.0)
