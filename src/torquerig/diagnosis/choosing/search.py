"""Which effects complete the model: each hypothesis fitted beside the model's own numbers, the best kept, and again."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import BENT, Case, line_residuals
from torquerig.diagnosis.choosing.gap_trial import fitted_gap, gap_is_possible, simulated_model
from torquerig.diagnosis.choosing.opened_gap import flanks_fly
from torquerig.diagnosis.choosing.possible import can_be, price_of_odd_numbers
from torquerig.diagnosis.choosing.screening import finalists, given_way_to, screened, stood_in_for
from torquerig.diagnosis.choosing.told_by_lines import spared
from torquerig.diagnosis.choosing.trial import LEAST_GAIN, PER_KNOB, Trial
from torquerig.diagnosis.fitting.calibration import Calibrated, calibrated
from torquerig.diagnosis.hypotheses import proposers
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.neutral import descriptions
from torquerig.errors import SimulationError
from torquerig.inference.knobs import turned
from torquerig.inference.places import Place
from torquerig.parallel import parallel_map
from torquerig.rig.assembly import Rig

MOST_EFFECTS = 3
_POLISHED = 2  # of the best, which are fitted on until nothing moves
_JOINT_DERIVATIVES = 2  # sets: what ranks high is fitted on
_CONTENDS = 0.5  # of the best gain from where the model stands: what has less is not begun from elsewhere
_NEAR = 2.0  # times the cost that a trial is to beat: one above it is fitted no further
WELL = 1.2  # misfit per feature below which a fit needs no second start
_EXPLAINED = 5.0  # a line counts as explained when its residual is below this in every run
_CLEARLY = 0.9  # share of the excess misfit that makes simulating a gap needless


@dataclass(frozen=True)
class Tried:
    """The hypotheses, best first: ``fitted`` with all numbers free, ``screened`` all of them, the model held fast.

    ``gap_failed`` where a gap was to be tried, and the model around it could not be simulated.
    """

    fitted: tuple[Trial, ...]
    screened: tuple[Trial, ...]
    gap_failed: bool = False


def trials(
    case: Case, *, simulated: bool = True, to_beat: float = np.inf, among: Collection[str] | None = None
) -> Tried:
    """Return the hypotheses fitted to what the model leaves.

    All are first fitted with the model held fast; the best of each of the most promising mechanisms then with all
    numbers free, from there and, what bends these numbers, as it was proposed. ``simulated`` ones, which take longest,
    may be left out, and all but those ``among`` some mechanisms. What stays twice as far off as a model ``to_beat``, by
    its cost, is fitted no further.
    """
    sources = (*proposers(case, among=among), descriptions)
    last_first = sources[::-1]  # they take longest
    of_sources = parallel_map(lambda propose: [screened(case, candidate) for candidate in propose(case)], last_first)
    tried = sorted((trial for each in reversed(of_sources) for trial in each), key=lambda trial: -trial.gain)
    last = [*finalists(tried), *given_way_to(case, tried)]
    last += stood_in_for(case, tried, last)
    near = _NEAR * to_beat
    fitted = _one_of_a_kind(sorted(_fitted(case, last, near=near), key=lambda trial: -trial.gain))
    best = [trial for trial in fitted[:_POLISHED] if trial.gain > LEAST_GAIN or _of_line(trial, fitted[0])]
    promising = [trial for trial in best if fitted[0].gain > LEAST_GAIN and trial.model.cost < near]
    fitted[: len(promising)] = parallel_map(partial(_polished, case), promising)
    gap_failed = False
    if simulated and gap_is_possible(case) and (flanks_fly(case) or not _cleared(case, fitted)):
        try:
            fitted += _gap(case)
        except SimulationError:
            gap_failed = True
    fitted = [_odds_paid(spared(case, trial)) for trial in fitted if can_be(trial.candidate, trial.model)]
    fitted.sort(key=lambda trial: -trial.gain)
    return Tried(tuple(fitted), tuple(tried), gap_failed)


def _odds_paid(trial: Trial) -> Trial:
    return replace(trial, gain=trial.gain - price_of_odd_numbers(trial.candidate, trial.model))


def _of_line(trial: Trial, best: Trial) -> bool:
    """Whether a trial is of the same line as the best."""
    return trial.candidate.place == best.candidate.place is not None


def _one_of_a_kind(fitted: Sequence[Trial]) -> list[Trial]:
    """Return the first of each mechanism, line and variant: some are fitted from two beginnings."""
    answer: dict[tuple[str, Place | None, str], Trial] = {}
    for trial in fitted:
        answer.setdefault((trial.candidate.mechanism, trial.candidate.place, trial.candidate.variant), trial)
    return [*answer.values()]


def _gap(case: Case) -> list[Trial]:
    """Return the trial of the fitted gap, or none where the recordings need none."""
    found = fitted_gap(case, case.nominal_with_accepted())
    if found is None:
        return []
    beside = (found.closed, found.opened)
    gain = case.model.cost - found.model.cost + found.closed - found.opened - PER_KNOB
    return [Trial(found.candidate, simulated_model(found.candidate, found.model), gain, beside)]


def extended(case: Case, best: Trial) -> Case:
    """Return the case with the winner in its model, and of the left lines those that it does not explain."""
    left = unexplained(case.left, case, best.model)
    return replace(case, model=best.model, accepted=(*case.accepted, best.candidate), left=left, apart=None)


def unexplained(peaks: Sequence[Peak], case: Case, model: Calibrated) -> tuple[Peak, ...]:
    """Return those of the peaks that a model of the case does not explain."""
    worst = line_residuals(case.seen, model.misfits)
    return tuple(peak for peak in peaks if worst.get(peak.place, 0.0) > _EXPLAINED)


def _cleared(case: Case, fitted: Sequence[Trial]) -> bool:
    """Whether one of the effects explains nearly all that the model misses."""
    return any(trial.gain >= _CLEARLY * excess(case) for trial in fitted)


def excess(case: Case) -> float:
    """How far the model's misfit lies above that of a true one."""
    return case.model.cost - feature_count(case.model)


def feature_count(model: Calibrated) -> int:
    """How many features there are, which is about the cost of a true model."""
    return sum(misfit.seen for misfit in model.misfits)


def _fitted(case: Case, screened_trials: Sequence[Trial], *, near: float) -> list[Trial]:
    """Return the trials with all numbers fitted together, each from the better of two beginnings.

    What is missing bends the numbers of the model that lacks it, sometimes too far to come back from where it stands.
    The other beginning, where the model stands apart from lines it lacks, costs twice as much: it is kept for those
    that come near the best without it (in 62 rounds with 24 blind rigs of two effects no other came first), below the
    cost ``near``, and are not right yet.
    """
    begun = parallel_map(partial(_from_here, case), screened_trials)
    enough = _CONTENDS * max((trial.gain for trial in begun), default=0.0)
    contend = [trial.gain > enough and trial.model.cost < near and not _fits_well(trial) for trial in begun]
    rows = np.flatnonzero(contend).tolist()
    again = parallel_map(partial(_from_apart, case), [screened_trials[row] for row in rows])
    for row, trial in zip(rows, again, strict=True):
        begun[row] = max(begun[row], trial, key=lambda one: one.gain)
    return begun


def _fits_well(trial: Trial) -> bool:
    return trial.model.cost < WELL * feature_count(trial.model)


def _from_here(case: Case, trial: Trial) -> Trial:
    """Fit all numbers together, from where the model stands, or beside which the candidate was looked at."""
    nuisance = trial.model.positions if trial.model.knobs == case.model.knobs else case.model.positions
    return _joint(case, trial, trial.model.rig, nuisance)


def _from_apart(case: Case, trial: Trial) -> Trial:
    """Fit all numbers together, from where the model stands apart from lines it lacks."""
    apart = case.apart if case.left and case.apart is not None else None
    if apart is None or np.abs(apart).max(initial=0.0) > BENT:
        apart = np.zeros(len(case.model.knobs))
    beside = trial.candidate.added_to(turned(case.nominal_with_accepted(), case.model.knobs, apart))
    held = case.model.corrections or None
    alone = calibrated(beside, case.seen, trial.candidate.knobs, derivatives=_JOINT_DERIVATIVES, corrections=held)
    return _joint(case, trial, alone.rig, apart)


def _joint(case: Case, trial: Trial, own: Rig, nuisance: NDArray[np.float64]) -> Trial:
    """Fit the numbers of the model, which begin at ``nuisance``, and the candidate's, which begin as in ``own``.

    The model's derivatives serve from apart, too: they are made anew where they fail, and what they cost is better
    spent there (25 recorded fits).
    """
    parts = tuple(own.part(part.name) for part in trial.candidate.parts)
    placed = replace(trial.candidate, parts=parts)
    model = calibrated(
        placed.added_to(case.nominal_with_accepted()), case.seen, (*case.model.knobs, *placed.knobs),
        start=np.concatenate([nuisance, np.zeros(len(placed.knobs))]), derivatives=_JOINT_DERIVATIVES,
        corrections=case.model.corrections or None, jacobian=case.model.jacobian,
    )  # fmt: skip
    gain = case.model.cost - model.cost - PER_KNOB * len(placed.knobs) - placed.price
    return Trial(placed, model, gain, alone=trial.alone)


def _polished(case: Case, trial: Trial) -> Trial:
    """Fit on from where the joint fit stopped."""
    rig = trial.candidate.added_to(case.nominal_with_accepted())
    model = calibrated(
        rig, case.seen, trial.model.knobs, start=trial.model.positions, corrections=case.model.corrections or None,
        jacobian=trial.model.jacobian, near=False,
    )  # fmt: skip
    better = model if model.cost < trial.model.cost else trial.model
    return replace(trial, model=better, gain=trial.gain + trial.model.cost - better.cost)
