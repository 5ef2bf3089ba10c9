"""Modes rung by impacts: a comb of lines as far as impacts keep their rhythm over a block, noise beyond.

Where the angle between impacts varies by the relative standard deviation s, the phase of line k of the comb walks at
random. The line is a Lorentzian of the half-width ``pi k^2 s^2`` impacts per second. In a block of N impacts under a
Hann window, 1.5 bins wide, ``1 / (1 + 2 x / 3)`` of its power is in the line, ``x = (2 pi k s)^2 N / 4``: right far
below and far above x = 1, by 17 % too low at x = 2. Source: phase noise, any text (Rutman 1978, Proc. IEEE 66).
"""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.linear_twin.twin import Twin
from torquerig.sensor_stages.ringing import Ringing

Floats = NDArray[np.float64]

_MOST_LINES = 400  # of a comb
_HIGHEST = 0.45  # of the sample rate
_HANN = 1.5  # [bins] noise bandwidth of a Hann window
_OF_IMPACTS = 3.0  # [1] times the share _HANN / N that N impacts without any rhythm leave in a line: less is noise


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


class CombLines(NamedTuple):
    """Lines of combs, shape (lines, segments).

    Frequencies [Hz], amplitudes in the line of a block [N m], which share of the power that is [1], and half-widths
    [Hz].
    """

    frequency: Floats
    amplitude: Floats
    share: Floats
    half_width: Floats


def ringing_lines(twin: Twin, seen: RunFeatures) -> CombLines:
    """Return the lines of the combs of all rung modes."""
    none = np.zeros((0, len(seen.segments)))
    found = [CombLines(none, none, none, none)]
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
        amplitude = np.sqrt(share * power * twin.amplifier_power(at))
        width = pi * (multiple * stage.slip) ** 2 * rate
        found.append(CombLines(at[kept], amplitude[kept], share[kept], width[kept]))
    return CombLines(*(np.concatenate(parts) for parts in zip(*found, strict=True)))


def _ringing(twin: Twin) -> list[Ringing]:
    return [stage for stage in twin.rig.stages() if isinstance(stage, Ringing)]


def _impacts(stage: Ringing, seen: RunFeatures) -> Floats:
    """Return the impacts per second in each segment, whichever way the shaft turns."""
    return np.asarray(stage.order * np.abs(stage.turns * seen.speed) / (2 * pi))


def _in_rhythm(stage: Ringing, seen: RunFeatures, row: int, multiple: Floats) -> Floats:
    """Return the share of the power that is in lines of the comb in a segment [1]; 0 where it is no more than noise."""
    impacts = max(float(_impacts(stage, seen)[row]) * seen.duration_of(seen.segments[row]), 1e-9)
    share = share_in_line(multiple, stage.slip, impacts)
    return np.where(share * impacts > _HANN * _OF_IMPACTS, share, 0.0)


def share_in_line(multiple: Floats, slip: float, impacts: float) -> Floats:
    """Return the share of its power that is in a line of the comb in a block of so many impacts [1]."""
    return np.asarray(1 / (1 + (2 * pi * multiple * slip) ** 2 * impacts / (4 * _HANN)))
