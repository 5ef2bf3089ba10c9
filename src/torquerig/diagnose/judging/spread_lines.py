"""Lines spread over a hertz or two: too wide for a peak, too narrow for a band of the spectrum to show them.

A line whose phase jumps L times a second is spread over about L/pi hertz (a Lorentzian, the spectrum of a phase that
forgets itself at that rate), as is a tone whose frequency wanders. What a load or a sensor makes is smooth over so
little.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import log10, pi

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from torquerig.diagnose.case import Case
from torquerig.diagnose.diagnosis import Mismatch
from torquerig.diagnose.judging.chance import by_chance
from torquerig.diagnose.looking.observed import Observed
from torquerig.diagnose.looking.order_or_fixed import ONE_SPEED
from torquerig.diagnose.looking.peaks import beside_lines
from torquerig.diagnose.looking.places import Place

Floats = NDArray[np.float64]

_WIDTHS = (1.5, 3.0)  # [Hz] over which the power is gathered
_SIDES = 4  # widths that the floor on either side is taken from
_FEWEST = 24  # bins of either side
_LOWEST, _HIGHEST = 5.0, 1000.0  # [Hz]
_BESIDE = 2.0  # bins either way that a line taken out leaves empty
_BINS_A_SPREAD = 3.1  # over the bins: variance of the logarithm of a median of exponential variates, Hann window
_CLEAR = 5.2  # spreads; chance alone reaches 4.2 on 30 clean rigs
_AGAIN = 3.0  # in a run of another speed, at the same order
_SKIRT, _MIRRORED = 0.06, 0.4  # within this share of a line's frequency, with this share of the spreads across the line


@dataclass(frozen=True)
class _Heights:
    """Of one run: by how many spreads the median power of a width stands above both sides, at each frequency [Hz]."""

    run: Observed
    width: float
    frequency: Floats
    height: Floats
    spreads: Floats

    def clearest(self, known: Sequence[Place]) -> int | None:
        """Return where it stands out most, unless that is a skirt: as high across a line of an unmeasured angle."""
        top = int(np.argmax(self.spreads)) if self.spreads.size else None
        if top is None or self.spreads[top] < _CLEAR:
            return None
        at, speed = float(self.frequency[top]), abs(self.run.mean_speed)
        lines = [place.frequency(speed) for place in known if place.domain == "order" and self.run.smearing]
        across = [self.near(2 * line - at) for line in lines if abs(line - at) < _SKIRT * line]
        return None if max(across, default=0.0) > _MIRRORED * self.spreads[top] else top

    def near(self, frequency: float) -> float:
        """Return the most spreads within half a width of a frequency; 0 where nothing is looked at."""
        there = np.abs(self.frequency - frequency) < 0.5 * self.width
        return float(self.spreads[there].max(initial=0.0))


def spread_lines(case: Case) -> Iterator[Mismatch]:
    """Yield where the steady runs show a spread line beside the case's known ones, one entry for each place.

    It turns where runs of another speed show it at the same order. ``share_of_misfit`` is 0: the bands and lines that
    fits compare do not show it.
    """
    known = case.seen[0].places
    every = [each for run in case.runs if run.steady and not run.rebuilt for each in _heights(run, known)]
    places = sum(each.spreads.size for each in every)
    told: list[tuple[str, float]] = []
    for one in every:
        top, speed = one.clearest(known), abs(one.run.mean_speed)
        if top is None:
            continue
        at = float(one.frequency[top])
        others = [each for each in every if abs(abs(each.run.mean_speed) / speed - 1) > ONE_SPEED]
        again = [each for each in others if each.near(at * abs(each.run.mean_speed) / speed) > _AGAIN]
        domain, scale = ("order", 2 * pi / speed) if again else ("frequency", 1.0)
        if any(kind == domain and abs(at * scale - where) < 2 * one.width * scale for kind, where in told):
            continue
        told.append((domain, at * scale))
        yield Mismatch(
            domain=domain, axis="motor_shaft" if again else "Hz", at=at * scale, width=one.width * scale,
            recordings=tuple(dict.fromkeys(each.run.name for each in (one, *again))),
            excess_dB=10 * log10(np.e) * float(one.height[top]), share_of_misfit=0.0,
            p_value=by_chance(float(one.spreads[top]), places),
        )  # fmt: skip


def _heights(run: Observed, known: Sequence[Place]) -> Iterator[_Heights]:
    rest = beside_lines(run, known)
    power = np.abs(np.fft.rfft((rest - rest.mean()) * np.hanning(rest.size))) ** 2
    step = run.rate / rest.size
    counts = np.zeros(power.size, dtype=bool)
    counts[int(_LOWEST / step) : int(min(_HIGHEST, 0.4 * run.rate) / step)] = True
    for place in known:
        at = place.frequency(abs(run.mean_speed)) / step
        smeared = run.smearing * at + 0.5 * _WIDTHS[0] / step if run.smearing and place.domain == "order" else 0.0
        beside = max(_BESIDE, smeared)
        counts[max(int(np.ceil(at - beside)), 0) : int(np.floor(at + beside)) + 1] = False
    left, frequency = power[counts], np.flatnonzero(counts) * step
    for width in _WIDTHS:
        bins = max(4, round(width / step))
        side = max(_FEWEST, _SIDES * bins)
        away = side // 2 + bins
        if left.size < 4 * (away + side):
            continue
        middle, wide = (np.maximum(median_filter(left, size=size, mode="nearest"), 1e-300) for size in (bins, side))
        inside = slice(away + side // 2, -(away + side // 2))
        floor = np.maximum(np.roll(wide, away), np.roll(wide, -away))[inside]
        height = np.log(middle[inside] / floor)
        yield _Heights(run, width, np.asarray(frequency[inside]), height, height / np.sqrt(_BINS_A_SPREAD / bins))
