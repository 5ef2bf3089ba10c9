"""Which effects complete the model: each hypothesis fitted beside the model's own numbers, the best kept, and again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from torquerig.diagnose.calibration import Calibrated, calibrated
from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.hypotheses import proposals
from torquerig.diagnose.peaks import Peak

MOST_EFFECTS = 3
PER_KNOB = 5.0  # what a further number must gain, beside the square of its own position
LEAST_GAIN = 40.0  # what an effect must gain to be called missing
_FINALISTS = 5
_EXPLAINED = 5.0  # a line counts as explained when its residual is below this in every run
_ALIKE = 0.12  # a rival within this share of the winner's gain cannot be told from it


@dataclass(frozen=True)
class Trial:
    """A candidate fitted together with all numbers of the model; ``gain`` is what the misfit fell by, knobs paid."""

    candidate: Candidate
    model: Calibrated
    gain: float


def trials(case: Case) -> list[Trial]:
    """Return the hypotheses fitted to what the model leaves, best first.

    All are first fitted with the model held fast; the best of each of the most promising mechanisms then with all
    numbers free.
    """
    screened = [_screened(case, candidate) for candidate in proposals(case)]
    screened.sort(key=lambda trial: -trial.gain)
    finalists: list[Trial] = []
    for trial in screened:
        if trial.gain > 0 and len(finalists) < _FINALISTS and not _repeated(trial, finalists):
            finalists.append(trial)
    fitted = [_joint(case, trial) for trial in finalists]
    fitted.sort(key=lambda trial: -trial.gain)
    return fitted


def extended(case: Case, best: Trial) -> Case:
    """Return the case with the winner in its model, and of the left lines those that it does not explain."""
    unexplained: list[Peak] = []
    for peak in case.left:
        misses = []
        for features, misfit in zip(case.seen, best.model.misfits, strict=True):
            column = features.places.index(peak.place)
            misses.append(float(np.abs(np.atleast_2d(misfit.lines)[:, column]).max()))
        if max(misses, default=0.0) > _EXPLAINED:
            unexplained.append(peak)
    return replace(case, model=best.model, accepted=(*case.accepted, best.candidate), left=tuple(unexplained))


def _repeated(trial: Trial, others: Sequence[Trial]) -> bool:
    """Whether the same mechanism stands among ``others`` for the same line already."""
    mine = trial.candidate
    same = [o for o in others if o.candidate.mechanism == mine.mechanism]
    return any(o.candidate.place == mine.place and o.candidate.variant == mine.variant for o in same) or len(same) > 1


def _screened(case: Case, candidate: Candidate) -> Trial:
    rig = candidate.added_to(case.model.rig)
    model = calibrated(rig, case.seen, candidate.knobs, evaluations=6)
    before = case.model.cost - float(case.model.positions @ case.model.positions)
    return Trial(candidate, model, before - model.cost - PER_KNOB * len(candidate.knobs))


def _joint(case: Case, trial: Trial) -> Trial:
    candidate, own = trial.candidate, trial.model
    parts = tuple(own.rig.part(part.name) for part in candidate.parts)
    placed = replace(candidate, parts=parts)
    base = case.nominal
    for earlier in case.accepted:
        base = earlier.added_to(base)
    knobs = (*case.model.knobs, *placed.knobs)
    start = np.concatenate([case.model.positions, np.zeros(len(placed.knobs))])
    model = calibrated(placed.added_to(base), case.seen, knobs, start=start, evaluations=10)
    return Trial(placed, model, case.model.cost - model.cost - PER_KNOB * len(placed.knobs))


def rivals(best: Trial, others: Sequence[Trial]) -> tuple[Trial, ...]:
    """Return the trials of other mechanisms that these recordings cannot tell from ``best``."""
    return tuple(
        trial
        for trial in others
        if trial.candidate.mechanism != best.candidate.mechanism and trial.gain > (1 - _ALIKE) * best.gain
    )
