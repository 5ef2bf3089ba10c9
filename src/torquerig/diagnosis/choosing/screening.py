"""Which hypotheses are worth fitting with all numbers of the model free."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from torquerig.diagnosis.case import BENT, Candidate, Case
from torquerig.diagnosis.choosing.explained import explained_share
from torquerig.diagnosis.choosing.trial import PER_KNOB, Trial
from torquerig.diagnosis.fitting.calibration import Calibrated, calibrated
from torquerig.diagnosis.fitting.profiled import profiled_cost
from torquerig.inference.knobs import turned

_FINALISTS, _OTHERS = 5, 3  # at most, and of those that do not move the slow torque alike at least
_WORTHWHILE = 0.25  # of the best screened gain: less is not caught up by fitting all numbers
_NEAR_BY = 20.0  # by which a rival may gain less of the same line with the model held: the numbers that bend decide it
_STOOD_IN = 3.0  # spreads of a number that may stand in for what would loosen it
_DERIVATIVES, _LOOSE_DERIVATIVES = 2, 3


def screened(case: Case, candidate: Candidate) -> Trial:
    """Return the candidate with its own numbers fitted, the model held but for what the candidate loosens."""
    rig = candidate.added_to(case.model.rig)
    loose = [knob for knob in case.model.knobs if knob.field in candidate.loosens]
    knobs, steps = (*candidate.knobs, *loose), _LOOSE_DERIVATIVES if loose else _DERIVATIVES
    model = calibrated(rig, case.seen, knobs, derivatives=steps, corrections=case.model.corrections or None)
    bent = [
        knob.name in candidate.bends and abs(at) > BENT
        for knob, at in zip(case.model.knobs, case.model.positions, strict=True)
    ]
    kept = case.model.positions[~np.array(bent, dtype=bool)]
    before = case.model.cost - float(kept @ kept)
    gain = before - model.cost - PER_KNOB * len(candidate.knobs) - candidate.price
    line = candidate.place is not None and not loose
    alone = explained_share(case.model.misfits, model.misfits) if line else 0.0
    return Trial(candidate, model, gain, alone=alone)


def finalists(tried: Sequence[Trial]) -> list[Trial]:
    """Return those worth fitting with all numbers free: the best, their close rivals, and what moves the slow torque.

    The last do not crowd out the others: what loosens the slow torque gains by that alone where it is bent. ``tried``
    are sorted, the largest gain first.
    """
    top = tried[0].gain if tried else 0.0
    answer: list[Trial] = []
    others = 0
    for trial in tried:
        alike = any(trial.candidate.loosens and other.candidate.loosens for other in answer)
        worthwhile = trial.gain > (0 if alike else _WORTHWHILE * max(top, 0.0))
        room = len(answer) < _FINALISTS or (not alike and others < _OTHERS)
        if worthwhile and room and not _repeated(trial, answer):
            answer.append(trial)
            others += not alike
    return [*answer, *_rivals(answer, tried)]


def _rivals(finalists: Sequence[Trial], tried: Sequence[Trial]) -> list[Trial]:
    """Return the best of each further mechanism that gains nearly as much of a finalist's line."""
    answer: list[Trial] = []
    for trial in tried:
        mine = trial.candidate
        same = [one for one in (*finalists, *answer) if one.candidate.place == mine.place is not None]
        other = all(one.candidate.mechanism != mine.mechanism for one in same)
        if same and other and trial.gain > max(one.gain for one in same) - _NEAR_BY:
            answer.append(trial)
    return answer


def given_way_to(case: Case, tried: Sequence[Trial]) -> list[Trial]:
    """Return what bends the model's numbers and gains what it promised once they give way; one of a kind.

    The numbers may have stood in for it, as an inertia for a heavy mode. Its own numbers, fitted while the model is
    held, then lead away from it, so that each is returned as it was proposed: beside the numbers as they stand or,
    where they have been bent too far to come back, as the scenario has them, whichever promises more.
    """
    bending = [trial.candidate for trial in tried if np.isfinite(trial.candidate.promised)]
    before = profiled_cost(case.model, case.model.rig, case.seen) if bending else 0.0
    answer: dict[str, Trial] = {}
    for candidate in bending:
        paid = PER_KNOB * len(candidate.knobs) + candidate.price
        for model in case.beginnings():
            beside = replace(model, rig=candidate.added_to(model.rig))
            trial = Trial(candidate, beside, before - profiled_cost(model, beside.rig, case.seen) - paid)
            best = answer.get(candidate.mechanism, trial)
            if trial.gain + candidate.price > candidate.promised and trial.gain >= best.gain:
                answer[candidate.mechanism] = trial
    return [*answer.values()]


def stood_in_for(case: Case, tried: Sequence[Trial], last: Sequence[Trial]) -> list[Trial]:
    """Return those for which numbers of the model that they loosen have been bent too far, and that are not ``last``.

    What bending cost is no misfit, so that they gain nothing where the model is held; the best of each mechanism begins
    as it was proposed, beside the numbers as the scenario has them.
    """
    pairs = zip(case.model.knobs, case.model.positions.tolist(), strict=True)
    bent = {knob.field for knob, at in pairs if abs(at) > _STOOD_IN}
    answer = {
        trial.candidate.mechanism: trial for trial in reversed(tried) if bent.intersection(trial.candidate.loosens)
    }
    for trial in last:
        answer.pop(trial.candidate.mechanism, None)
    model = _unbent(case) if answer else case.model
    return [replace(trial, model=replace(model, rig=trial.candidate.added_to(model.rig))) for trial in answer.values()]


def _unbent(case: Case) -> Calibrated:
    """Return the model with the scenario's numbers as the scenario has them, and those of what was found as fitted."""
    found = {part.name for candidate in case.accepted for part in candidate.parts}
    own = np.array([knob.part in found for knob in case.model.knobs], dtype=bool)
    positions = np.where(own, case.model.positions, 0.0)
    return replace(
        case.model, rig=turned(case.nominal_with_accepted(), case.model.knobs, positions), positions=positions
    )


def _repeated(trial: Trial, others: Sequence[Trial]) -> bool:
    """Whether the same mechanism stands among ``others`` for the same line already."""
    mine = trial.candidate
    same = [o for o in others if o.candidate.mechanism == mine.mechanism]
    return any(o.candidate.place == mine.place and o.candidate.variant == mine.variant for o in same) or len(same) > 1
