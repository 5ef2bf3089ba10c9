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
from torquerig.diagnose.looking.peaks import beside_lines
from torquerig.diagnose.looking.places import Place

Floats = NDArray[np.float64]

_WIDTHS = (1.5, 3.0)  # [Hz] over which the power is gathered
_SIDES = 4  # widths that the floor on either side is taken from
_FEWEST = 24  # bins of either side
_LOWEST, _HIGHEST = 5.0, 1000.0  # [Hz]
_BESIDE = 2.0  # bins either way that a line taken out leaves empty
_BINS_A_SPREAD = 3.1  # over the bins: variance of the logarithm of a median of exponential variates, Hann window
_CLEAR = 5.2  # spreads of one run, or of several together; chance alone reaches 4.9 on 120 clean rigs
_SHOWS = 2.0  # in a run that is named
_STEP = 0.125  # [Hz] of the grid on which runs are put together
_TURNS = 1.0  # spreads more, at one order than at one frequency
_SKIRT, _MIRRORED = 0.06, 0.4  # within this share of a line's frequency, with this share of the spreads across the line


@dataclass(frozen=True)
class _Beside:
    """Power of a run at the frequencies [Hz] beside its known lines, ``step`` [Hz] apart where none is near."""

    run: Observed
    frequency: Floats
    power: Floats
    step: float


@dataclass(frozen=True)
class _Heights:
    """Of one run: by how many spreads the median power of a width stands above both sides, at each frequency [Hz]."""

    run: Observed
    frequency: Floats
    height: Floats
    spreads: Floats

    def at(self, frequency: Floats) -> tuple[Floats, Floats]:
        """Return spreads and height nearest to each frequency; 0 where none is looked at within a step or two."""
        after = np.clip(np.searchsorted(self.frequency, frequency), 1, self.frequency.size - 1)
        nearer = np.abs(self.frequency[after - 1] - frequency) < np.abs(self.frequency[after] - frequency)
        index = after - nearer
        there = np.abs(self.frequency[index] - frequency) < 2 * _STEP
        return np.where(there, self.spreads[index], 0.0), np.where(there, self.height[index], 0.0)


@dataclass(frozen=True)
class _Together:
    """Runs put together at orders of the motor [1/rev] or at frequencies [Hz]: ``scale`` [Hz] is what one of ``at`` is.

    ``spreads`` are those of the run that shows most; at orders of the runs that show most, so many that it is most.
    """

    domain: str
    width: float
    runs: tuple[_Heights, ...]
    at: Floats
    scales: Floats
    spreads: Floats

    def told(self, known: Sequence[Place], places: int) -> Mismatch | None:
        """Return where they stand out most; None unless clearly, or where that is a skirt of a known line."""
        top = int(np.argmax(self.spreads))
        if self.spreads[top] < _CLEAR or self._skirt(top, known):
            return None
        each = [
            heights.at(self.at[top : top + 1] * scale) for heights, scale in zip(self.runs, self.scales, strict=True)
        ]
        shown = [run.run.name for run, (spreads, _) in zip(self.runs, each, strict=True) if spreads[0] > _SHOWS]
        return Mismatch(
            domain=self.domain, axis="motor_shaft" if self.domain == "order" else "Hz", at=float(self.at[top]),
            width=self.width / float(self.scales.mean()), recordings=tuple(shown),
            excess_dB=10 * log10(np.e) * max(float(height[0]) for _, height in each), share_of_misfit=0.0,
            p_value=by_chance(float(self.spreads[top]), places),
        )  # fmt: skip

    def _skirt(self, top: int, known: Sequence[Place]) -> bool:
        """Whether the run that shows most stands out as well across a line of an angle that was not measured."""
        each = [
            heights.at(self.at[top : top + 1] * scale)[0][0]
            for heights, scale in zip(self.runs, self.scales, strict=True)
        ]
        most = int(np.argmax(each))
        heights, at = self.runs[most], float(self.at[top] * self.scales[most])
        lines = [place.frequency(abs(heights.run.mean_speed)) for place in known if place.domain == "order"]
        across = [np.abs(heights.frequency - (2 * line - at)) < 0.5 * self.width
                  for line in lines if abs(line - at) < _SKIRT * line]  # fmt: skip
        mirrored = max((float(heights.spreads[there].max(initial=0.0)) for there in across), default=0.0)
        return not heights.run.angle_measured and mirrored > _MIRRORED * each[most]


def spread_lines(case: Case) -> Iterator[Mismatch]:
    """Yield where the steady runs together show a spread line beside the case's known ones, clearest first.

    At one order or at one frequency, whichever the runs show better. ``share_of_misfit`` is 0: the bands and lines
    that fits compare do not show it.
    """
    known, steady = case.seen[0].places, [run for run in case.runs if run.steady and not run.rebuilt]
    seen, every = [_beside(run, known) for run in steady], list[_Together]()
    for width in _WIDTHS:
        runs = tuple(each for beside in seen if (each := _heights(beside, width)) is not None)
        every += [_together(domain, runs, width) for domain in ("frequency", "order")] if runs else []
    places = sum(each.at.size for each in every)
    found = [(each.spreads.max() - _TURNS * (each.domain == "order"), told)
             for each in every if (told := each.told(known, places)) is not None]  # fmt: skip
    if found:
        yield max(found, key=lambda row: row[0])[1]


def _together(domain: str, runs: tuple[_Heights, ...], width: float) -> _Together:
    speeds = np.array([abs(heights.run.mean_speed) for heights in runs])
    scales = speeds / (2 * pi) if domain == "order" else np.ones(speeds.size)
    at = np.arange(_LOWEST / scales.min(), _HIGHEST / scales.max(), _STEP / scales.max())
    spreads = np.sort([heights.at(at * scale)[0] for heights, scale in zip(runs, scales, strict=True)], axis=0)[::-1]
    if domain == "frequency":  # there every run has the modes of the rig, which no model has to the last hertz
        return _Together(domain, width, runs, at, scales, spreads[0])
    number = np.arange(1, len(runs) + 1)[:, None]
    return _Together(domain, width, runs, at, scales, (np.cumsum(spreads, axis=0) / np.sqrt(number)).max(axis=0))


def _beside(run: Observed, known: Sequence[Place]) -> _Beside:
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
    return _Beside(run, np.asarray(np.flatnonzero(counts) * step), power[counts], step)


def _heights(beside: _Beside, width: float) -> _Heights | None:
    """Return how high the run stands out, None where lines leave too little of it."""
    bins = max(4, round(width / beside.step))
    side = max(_FEWEST, _SIDES * bins)
    away = side // 2 + bins
    if beside.power.size < 4 * (away + side):
        return None
    middle, wide = (np.maximum(median_filter(beside.power, size=size, mode="nearest"), 1e-300) for size in (bins, side))
    inside = slice(away + side // 2, -(away + side // 2))
    floor = np.maximum(np.roll(wide, away), np.roll(wide, -away))[inside]
    height = np.log(middle[inside] / floor)
    return _Heights(beside.run, beside.frequency[inside], height, height / np.sqrt(_BINS_A_SPREAD / bins))
