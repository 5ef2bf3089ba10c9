"""Whether the load of the steady runs stays what it is: a bed may wear in, grains may jam and let go.

A random load has no course: its means over a second scatter about one level, and what it has gathered it does not lose
within milliseconds. On 156 rigs with nothing hidden, of two programs, the course of all loaded runs together was 3.0 of
its spreads at most, and none had two falls beyond 6; a bed that lost 27 % of its load had 10, one that jammed to 70 %
above its mean seven falls in 12 s.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log10

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.chance import by_chance
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.recordings.repair.robust_spread import spread_about_median

Floats = NDArray[np.float64]

_BLOCKS = 12  # of a run; a second of a usual one, over which hits and slow variation are independent
_SHORTEST = 6.0  # [s]
_FLOOR = 0.005  # of a course over half a run: no level is steadier
_CLEAR = 6.0  # spreads of all runs together
_MEAN, _BETWEEN, _HOP = 0.05, 0.005, 0.01  # [s] over which a level is taken, and what lies between two of them
_FALL, _FEWEST, _APART = 6.0, 3, 0.08  # spreads, falls in a run, and [s] between two


def load_over_time(case: Case) -> tuple[str, Mismatch] | None:
    """Return a sentence and a mismatch for a load that changes along the runs or falls suddenly; else None."""
    loaded = [
        run
        for run in case.runs
        if run.steady and not run.rebuilt and run.run.occupancy_percent and run.recording.duration > _SHORTEST
    ]
    return _course(loaded) or _falls(loaded)


def _course(runs: Sequence[Observed]) -> tuple[str, Mismatch] | None:
    """Tell the common slope of all runs' levels, each relative to its mean, a parabola beside it."""
    if not runs:
        return None
    slope, spread = np.array([_slope(run) for run in runs]).T
    weight = spread**-2
    common, clear = float(slope @ weight / weight.sum()), float(slope @ weight / np.sqrt(weight.sum()))
    if abs(clear) < _CLEAR:
        return None
    sentence = (
        f"The load of the steady recordings {'falls' if common < 0 else 'rises'} by {2 * abs(common):.0%} of its mean "
        "from start to end. No mechanism of the library changes the load over time."
    )
    longest = max(run.recording.duration for run in runs)
    return sentence, Mismatch(
        domain="time", axis="s", at=0.5 * longest, width=longest, recordings=tuple(run.name for run in runs),
        excess_dB=20 * log10(1 + abs(2 * common)), share_of_misfit=0.0, p_value=by_chance(abs(clear), 1),
    )  # fmt: skip


def _slope(run: Observed) -> tuple[float, float]:
    """Return by how much the level rises over half a run, as a share of its mean, and the spread of that."""
    levels = run.torque[: run.torque.size // _BLOCKS * _BLOCKS].reshape(_BLOCKS, -1).mean(axis=1)
    along = np.linspace(-1.0, 1.0, _BLOCKS)
    shapes = np.stack([np.ones(_BLOCKS), along, along**2], axis=1)
    relative = levels / (abs(levels.mean()) or 1.0)
    found, *_ = np.linalg.lstsq(shapes, relative)
    scatter = float(np.sum((relative - shapes @ found) ** 2)) / (_BLOCKS - shapes.shape[1])
    variance = scatter * np.linalg.inv(shapes.T @ shapes)[1, 1]
    return float(found[1]) * (1.0 if levels.mean() > 0 else -1.0), max(float(np.sqrt(variance)), _FLOOR)


def _falls(runs: Sequence[Observed]) -> tuple[str, Mismatch] | None:
    """Tell the run whose load falls most often within milliseconds."""
    found = [(_sudden(run), run) for run in runs]
    falls, run = max(found, key=lambda row: row[0].size, default=(np.zeros(0), None))
    if run is None or falls.size < _FEWEST:
        return None
    sentence = (
        f"{run.name}: the load falls {falls.size} times within milliseconds, first at {falls[0]:.2f} s. The load "
        "builds up and releases suddenly. No mechanism of the library does that."
    )
    return sentence, Mismatch(
        domain="time", axis="s", at=float(falls[0]), width=2 * _MEAN,
        recordings=tuple(each.name for times, each in found if times.size >= _FEWEST), excess_dB=20 * log10(_FALL),
        share_of_misfit=0.0, p_value=by_chance(_FALL, int(run.recording.duration / _HOP)) ** falls.size,
    )  # fmt: skip


def _sudden(run: Observed) -> Floats:
    """Return when the level of a run falls suddenly [s]."""
    length, between, hop = (max(1, round(time * run.rate)) for time in (_MEAN, _BETWEEN, _HOP))
    summed = np.concatenate([[0.0], np.cumsum(run.torque * np.sign(run.torque.mean()))])
    level = (summed[length:] - summed[:-length]) / length
    steps = (level[length + between :] - level[: -length - between])[::hop]
    spread = spread_about_median(steps)
    times = np.flatnonzero(steps < -_FALL * max(spread, np.finfo(float).tiny)) * hop / run.rate + _MEAN
    return times[np.diff(times, prepend=-np.inf) > _APART]
