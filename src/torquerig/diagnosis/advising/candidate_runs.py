"""Runs that a laboratory could do next: other speeds, other loads, a ramp, a reversal, least effort first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import pi

from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import ParticleLoad
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig

_SPEEDS = (0.72, 1.29)  # of the speed that was run; at 0.7 and 1.3 many whole orders fall on others
_ROUNDED = 10.0  # [rpm]
_SAME = 0.03  # a speed within this share of one that was run is no other speed
_LOADS = 3


@dataclass(frozen=True)
class CandidateRun:
    """A run to do, and how it is said."""

    run: Run
    words: str


def candidate_runs(rig: Rig, runs: Sequence[Observed]) -> tuple[CandidateRun, ...]:
    """Return the runs that were not done yet, least effort first: speed, load, both, ramp, reversal.

    Speeds lie some 30 % below and above that of the fastest steady run; loads are those that the rig states a mean for.
    """
    base = max((one.run for one in runs), key=lambda run: (run.profile == "steady", run.speed or 0.0))
    speed, load = base.speed or 0.0, base.occupancy_percent
    steady = [one.run for one in runs if one.run.profile == "steady"]
    if not speed:
        return ()
    speeds = [_rounded(speed * factor) for factor in _SPEEDS]
    loads = [one for one in _loads(rig) if one != load]
    options = [(one, load) for one in speeds] + [(speed, one) for one in loads]
    options += [(one, other) for one in speeds for other in loads]
    answer = [_steady(base, one, other) for one, other in options if not _done(one, other, steady)]
    return (*answer, *_moving(base, {one.run.profile for one in runs}))


def _steady(base: Run, speed: float, load: float | None) -> CandidateRun:
    run = replace(base, speed=speed, occupancy_percent=load, profile="steady", set_points=None)
    said = f"Repeat at {speed * 30 / pi:.0f} rpm"
    return CandidateRun(run, said if load == base.occupancy_percent else f"{said} {_load_words(load)}")


def _moving(base: Run, done: set[str]) -> Iterator[CandidateRun]:
    rpm, load = (base.speed or 0.0) * 30 / pi, _load_words(base.occupancy_percent)
    if "ramp" not in done:
        yield CandidateRun(replace(base, profile="ramp", set_points=None), f"Record a ramp up to {rpm:.0f} rpm {load}")
    if "reversal" not in done:
        words = f"Record a reversal with an amplitude of {rpm:.0f} rpm {load}"
        yield CandidateRun(replace(base, profile="reversal", set_points=None), words)


def _load_words(load: float | None) -> str:
    if load is None:
        return "with the same load"
    return "at idle" if load == 0 else f"with an occupancy of {load:g} %"


def _loads(rig: Rig) -> list[float]:
    """Idle, the heaviest, and one between, of the loads that the rig states a mean for."""
    stated = sorted({percent for load in rig.parts_of(ParticleLoad) for percent in load.mean_by_occupancy_percent})
    if len(stated) <= _LOADS:
        return stated
    return [stated[0], stated[len(stated) // 2], stated[-1]]


def _rounded(speed: float) -> float:
    return round(speed * 30 / pi / _ROUNDED) * _ROUNDED * pi / 30


def _done(speed: float, load: float | None, steady: Sequence[Run]) -> bool:
    return any(run.speed and abs(run.speed / speed - 1) < _SAME and run.occupancy_percent == load for run in steady)
