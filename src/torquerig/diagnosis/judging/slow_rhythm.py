"""Pulses of the torque in a slow rhythm of fixed period, which no shaft has: many lines, each too small to stand out.

What a feeder, a valve or a neighbour does once in a second or so makes a line at every multiple of its frequency. Below
some 40 Hz each drowns in the load's own chance, over a dozen of them together they do not (the power of a harmonic comb
summed over its lines: the harmonic sum spectrum of Noll 1969, Proc. Symp. Computer Processing in Communications 779).
"""

from __future__ import annotations

from math import log, log10
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter
from scipy.stats import gamma

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import beside_lines
from torquerig.inference.answer.mismatch import Mismatch

Floats = NDArray[np.float64]

_SLOWEST, _FASTEST = 0.45, 4.0  # [Hz] of the rhythm
_LOWEST, _HIGHEST = 2.0, 40.0  # [Hz] of its lines
_FEWEST = 8  # lines of a comb that are looked at
_TOWERS = 12.0  # times the floor: a line that stands higher counts so much
_FLOOR = 3.0  # [Hz] over which the floor is taken
_LINE = 3.0  # bins either way that a line of a shaft takes under a Hann window
_CLEAR = (
    1e-9  # chance of so much power at one frequency; some hundreds are asked of a run, and 60 clean runs reach 2e-5
)


class _Power(NamedTuple):
    """Power over the floor at each frequency [Hz] of a run, not a number where a shaft has lines."""

    step: float
    over: Floats


class _Rhythm(NamedTuple):
    chance: float
    frequency: float
    over: float


def slow_rhythm(case: Case) -> Mismatch | None:
    """Return the clearest slow rhythm of the steady runs, None where none shows."""
    found = [(_clearest(_power(run, case)), run) for run in case.runs if run.steady and not run.rebuilt]
    best, run = min(found, key=lambda row: row[0].chance, default=(_Rhythm(1.0, 0.0, 1.0), None))
    if run is None or best.chance > _CLEAR:
        return None
    return Mismatch(
        domain="frequency", axis="Hz", at=best.frequency, width=1 / run.recording.duration,
        recordings=tuple(each.name for rhythm, each in found if _alike(rhythm, best)),
        excess_dB=10 * log10(best.over), share_of_misfit=0.0, p_value=best.chance,
    )  # fmt: skip


def _alike(one: _Rhythm, other: _Rhythm) -> bool:
    return one.chance < _CLEAR and abs(one.frequency / other.frequency - 1) < 0.02


def _power(run: Observed, case: Case) -> _Power:
    left = {peak.place for peak in case.left}  # what the model lacks may be the rhythm's own lines
    lines = [place for place in case.seen[0].places if place not in left]
    rest = beside_lines(run, lines)
    power = np.abs(np.fft.rfft((rest - rest.mean()) * np.hanning(rest.size))) ** 2
    step = run.rate / rest.size
    power = power[: int((_HIGHEST + _FLOOR) / step) + 1]
    frequency = np.arange(power.size) * step
    shown = np.ones(power.size, dtype=bool)
    for place in lines:
        shown &= np.abs(frequency - abs(place.frequency(run.mean_speed))) > _LINE * step + run.smearing * frequency
    floor = median_filter(power[shown], size=max(9, round(_FLOOR / step)), mode="nearest") / log(2)
    over = np.full(power.size, np.nan)
    over[shown] = power[shown] / np.maximum(floor, 1e-300)
    return _Power(step, over)


def _clearest(power: _Power) -> _Rhythm:
    best, grid = _Rhythm(1.0, 0.0, 1.0), 0.5 * power.step * _SLOWEST / _HIGHEST
    for frequency in np.arange(_SLOWEST, _FASTEST, grid * 4):
        lines = np.arange(np.ceil(_LOWEST / frequency), np.floor(_HIGHEST / frequency) + 1) * frequency
        over = power.over[np.round(lines / power.step).astype(int)]
        over = np.minimum(over[np.isfinite(over)], _TOWERS)
        if over.size >= _FEWEST:
            chance = float(gamma.sf(over.sum(), over.size))
            if chance < best.chance:
                best = _Rhythm(chance, float(frequency), float(over.mean()))
    return best
