"""Which next run would separate hypotheses: each is simulated in runs that were not done yet, and the runs compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.advising.candidate_runs import CandidateRun, candidate_runs
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.equivalence import CHANCE
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.expecting.expectation import Expectation, expected
from torquerig.diagnosis.expecting.simulated import expected_by_simulation
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit, misfit
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import Observed, observed
from torquerig.errors import SimulationError
from torquerig.inference.knobs import turned
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.inference.places import Place, frequency, order
from torquerig.linear_twin.twin import Twin
from torquerig.parallel import parallel_map
from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.scenario.kinematics import kinematics_of
from torquerig.sensor_stages.tone import Tone, folded
from torquerig.simulation.simulator import simulate

# a rival D spreads away fits worse by D^2 give or take 2 D, so it is excluded as often as not at twice CHANCE
ENOUGH, CERTAIN = 2 * CHANCE, 3 * CHANCE  # beyond the second, nine times in ten
Floats = NDArray[np.float64]

_STEP = 0.1  # of a number's spread, for the slopes
_RIDGE = 1e-9
_LENGTH = 4.0  # [s] of a simulated candidate
_SEED = 7
_AT_A_TIME = 2


@dataclass(frozen=True)
class Advice:
    """A run, and the smallest distance between two hypotheses in it, in units of the features' spread [1]."""

    candidate: CandidateRun
    distance: float
    because: str

    def sentence(self) -> str:
        """Return the advice in words."""
        return f"{self.candidate.words}. {self.because}"


def next_run(case: Case, trials: Sequence[Trial]) -> Advice | None:
    """Return the run in which the two nearest hypotheses lie furthest apart; None where no run separates any.

    T-optimality over a menu of runs (Atkinson & Fedorov 1975, Biometrika 62(1)): the distance of two models is the
    root of the sum of squares of the differences of their expected features, each in units of its spread, that is left
    when one of them is fitted anew to what the other expects. Runs that all tell for certain count the same; of these
    the one of least effort is advised, and no dearer one is tried.
    """
    if len(trials) < 2:
        return None
    menu, advised = candidate_runs(case.nominal, case.runs), list[Advice]()
    for few in (menu[at : at + _AT_A_TIME] for at in range(0, len(menu), _AT_A_TIME)):
        advised += parallel_map(partial(_judged, case, trials), few)
        if any(one.distance >= CERTAIN for one in advised):
            break
    best = max(advised, key=lambda one: min(one.distance, CERTAIN), default=None)
    return best if best is not None and best.distance > ENOUGH else None


def _judged(case: Case, trials: Sequence[Trial], candidate: CandidateRun) -> Advice:
    """Judge a run, simulated with the first hypothesis, by the pair that it separates least."""
    places = _places(case, [trial.model.rig for trial in trials], candidate.run)
    try:
        imagined = _imagined(trials[0].model.rig, candidate.run, case.runs[0])
    except SimulationError:  # the rival's fitted numbers do not run: this run would tell nothing
        return Advice(candidate, 0.0, "")
    seen = features(imagined, places, held=None)
    models = _expectations(trials, seen)
    misfits = [misfit(seen, model) for model in models]
    slopes = [np.zeros((0, 0)), *(_slopes(trial.model, seen) for trial in trials[1:])]
    nearest = Advice(candidate, float("inf"), "")
    for one, other in combinations(range(len(trials)), 2):
        gap = misfits[other].all() - misfits[one].all()
        distance = _left(gap, slopes[other], trials[other].model.covariance)
        if distance < nearest.distance:
            names = trials[one].candidate.mechanism, trials[other].candidate.mechanism
            said = _because(names, seen, (models[one], models[other]), (misfits[one], misfits[other]))
            nearest = Advice(candidate, distance, f"{said} The difference is {distance:.0f} standard deviations.")
    return nearest


def _slopes(model: Calibrated, seen: Features) -> Floats:
    """Return how the residuals move per spread of each number of a model; none where the twin does not hold it."""
    if model.corrections:
        return np.zeros((0, 0))
    here = misfit(seen, expected(model.rig, seen)).all()
    columns = []
    for number in range(len(model.knobs)):
        step = np.zeros(len(model.knobs))
        step[number] = _STEP
        moved = turned(model.rig, model.knobs, step)
        columns.append((misfit(seen, expected(moved, seen)).all() - here) / _STEP)
    return np.array(columns).T.reshape(here.size, len(columns))


def _left(gap: Floats, slopes: Floats, covariance: Floats) -> float:
    """Return how far residuals that lie apart by ``gap`` stay apart when one of the models is fitted anew.

    With slopes J and numbers known from the recordings to a covariance C, the squares that a new fit leaves of a gap d
    are d'd - d'J (C^-1 + J'J)^-1 J'd (linear least squares with C as prior).
    """
    if not slopes.size:
        return float(np.linalg.norm(gap))
    held = np.linalg.pinv(covariance) + slopes.T @ slopes + _RIDGE * np.eye(slopes.shape[1])
    closed = float(gap @ slopes @ np.linalg.solve(held, slopes.T @ gap))
    return sqrt(max(float(gap @ gap) - closed, 0.0))


def _expectations(trials: Sequence[Trial], seen: Features) -> list[Expectation]:
    """By the linear twin; all by simulation where an effect is beyond it."""
    if any(trial.model.corrections for trial in trials):
        return [expected_by_simulation(trial.model.rig, [seen], seeds=(_SEED + 1,))[0] for trial in trials]
    return [expected(trial.model.rig, seen) for trial in trials]


def _imagined(rig: Rig, run: Run, like: Observed) -> Observed:
    """Return a simulated run, its angle known as well as in the recordings."""
    recording = simulate(rig.at(run), duration=_LENGTH, seed=_SEED, sample_rate=like.rate)
    angle = ShaftAngle(recording.channels["true_motor_angle_rad"].values, like.angle_measured, "simulated")
    return observed(recording, angle, ratio=kinematics_of(rig).ratio)


def _places(case: Case, rigs: Sequence[Rig], run: Run) -> list[Place]:
    """Return the places of the recordings and of every line and tone that a rival has in the run.

    But for side lines: no diagnosis looks for one that is not there, so its lack would tell nothing.
    """
    places = dict.fromkeys(case.seen[0].places)
    for rig in rigs:
        placed = rig.at(run)
        own = [line for line in Twin(placed).lines() if line.transfer.answer is None]
        places.update((order(line.order), None) for line in own)
        for stage in placed.stages():
            if isinstance(stage, Tone):
                tones = [folded(k * stage.frequency, case.runs[0].rate) for k in range(1, len(stage.amplitudes) + 1)]
                places.update((frequency(tone), None) for tone in tones if tone > 0)
    return list(places)


def _because(
    names: tuple[str, str], seen: Features, models: tuple[Expectation, Expectation], misfits: tuple[Misfit, Misfit]
) -> str:
    """Say where the two differ most and what each expects there."""
    one, other = (name.replace("_", " ") for name in names)
    gaps = {
        kind: float(np.abs(getattr(misfits[1], kind) - getattr(misfits[0], kind)).max(initial=0.0))
        for kind in ("lines", "bands", "level", "turning")
    }
    kind = max(gaps, key=lambda name: gaps[name])
    if kind == "lines":
        apart_by = np.abs(np.atleast_2d(misfits[1].lines) - np.atleast_2d(misfits[0].lines)).max(axis=0)
        column = int(np.argmax(apart_by))
        sizes = [1e3 * float(model.amplitude[:, column].mean()) for model in models]
        at = _where(seen, column)
        return f"There, {one} predicts {sizes[0]:.2g} mN m {at}, and {other} {sizes[1]:.2g} mN m."
    if kind == "bands":
        band = int(np.argmax(np.abs(misfits[1].bands - misfits[0].bands)))
        ratio = 10 * float(np.log10(models[0].power[band] / models[1].power[band]))
        way = "more than" if ratio > 0 else "less than"
        return f"There, {one} predicts {abs(ratio):.1f} dB {way} {other} near {seen.band[band]:.0f} Hz."
    return f"There, {one} and {other} predict different slow torques."


def _where(seen: Features, column: int) -> str:
    place = seen.places[column]
    mean = place.frequency(float(np.abs(seen.speed).mean()))
    turning = f" (motor order {place.at:g})" if place.domain == "order" else ""
    return f"at {mean:.4g} Hz{turning}" if seen.observed.steady else f"in the line at {place.at:g} {_unit(place)}"


def _unit(place: Place) -> str:
    return "Hz" if place.domain == "frequency" else "per motor turn"
