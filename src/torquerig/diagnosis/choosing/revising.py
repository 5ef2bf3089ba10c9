"""Looking back once all effects are in: each must be needed beside the others, and still be the best of its kind.

An effect that was taken first, while another was missing, may have stood in for it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.around_gap import gap_anew, told_again
from torquerig.diagnosis.choosing.opened_gap import GAP
from torquerig.diagnosis.choosing.possible import can_be
from torquerig.diagnosis.choosing.search import Tried, extended, trials, unexplained
from torquerig.diagnosis.choosing.trial import LEAST_GAIN, PER_KNOB, Trial
from torquerig.diagnosis.fitting.calibration import Calibrated, calibrated
from torquerig.inference.places import SAME_ORDER, Place
from torquerig.parallel import parallel_map

_RIVALS = 0.02  # of an effect's gain
_BESIDE_ANOTHER = 0.25  # of what another gains at the same line
_BESIDE_A_GAP = 0.1  # of what the gap gains


@dataclass(frozen=True, kw_only=True, eq=False)
class Accepted:
    """A trial that was taken into the model, with the case before it and all that were tried there.

    ``again`` is the same beside all other effects, where looking back left it in its place.
    """

    before: Case
    trial: Trial
    tried: Tried
    again: Accepted | None = None


def revised(first: Case, accepted: Sequence[Accepted]) -> tuple[Accepted, ...]:
    """Return the effects that remain when each had to prove itself beside the others.

    Parameters
    ----------
    first : Case
        The calibrated nominal model, with all left lines.
    accepted : sequence of Accepted
        In the order in which they were taken.
    """
    kept = list(accepted)
    at = 0
    while len(kept) > 1 and at < len(kept) - 1:  # the last one was chosen beside all others
        if kept[at].trial.model.corrections:
            at += 1
            continue
        others = _without(first, kept, at)
        final = kept[-1].trial.model
        needed = max(_of_the_same_line(kept, at), LEAST_GAIN + PER_KNOB * len(kept[at].trial.candidate.knobs))
        if others.model.cost - final.cost < needed and final.corrections:
            others, needed = _beside_a_gap(first, others), max(needed, _of_the_gap(kept))
        if others.model.cost - final.cost < needed:
            kept = with_gap([*kept[:at], *kept[at + 1 :]], _gap_of(others))
            kept[-1] = replace(kept[-1], trial=_as_last(kept, others.model))  # the one without what is gone
            before = _without(first, kept, len(kept) - 1) if len(kept) > 1 else first
            kept[-1] = replace(kept[-1], before=before)
            continue
        possible = can_be(kept[at].trial.candidate, final)
        among = _rivals(kept[at]) | (frozenset() if possible else {kept[at].trial.candidate.mechanism})
        tried = trials(others, simulated=False, to_beat=final.cost, among=among) if among else Tried((), ())
        beside = replace(kept[at].trial, model=final, gain=_gain(kept[at].trial, others.model, final))
        better = _best_rival(others, tried, beside)
        if better is None or better.model.cost > final.cost - LEAST_GAIN:
            better = None if possible else _anew(tried, beside)
        if better is not None:
            remaining = with_gap([*kept[:at], *kept[at + 1 :]], better.gap)
            kept = [*remaining, Accepted(before=others, trial=better, tried=tried)]
            continue
        kept[at] = replace(kept[at], again=Accepted(before=others, trial=beside, tried=tried))
        at += 1
    return tuple(kept)


def _best_rival(others: Case, tried: Tried, taken: Trial) -> Trial | None:
    """Return the best of what was tried in the place of what was taken; None where that is the same mechanism.

    A gap that was found after it had its width told around what was taken: where the rival is ahead beside that gap
    all the same, the width is told again around it.
    """
    best = next(iter(tried.fitted), None)
    if best is None or not _other(best, taken):
        return None
    again = told_again(others, best) if best.gain > taken.gain else None
    return best if again is None else again


def _anew(tried: Tried, taken: Trial) -> Trial | None:
    """Return the same effect begun anew beside all others, where it fits as well; None where it does not.

    What was fitted while another effect was missing may have run to numbers that cannot be, and found no way back.
    """
    same = (each for each in tried.fitted if not _other(each, taken))
    return next((each for each in same if each.model.cost < taken.model.cost + LEAST_GAIN), None)


def _of_the_same_line(kept: Sequence[Accepted], at: int) -> float:
    """Return what an effect must take away beside later ones that stand at its line; 0 where none does.

    How two sources of one line add up depends on phases that nobody knows, so that a second one always helps.
    """
    place = kept[at].trial.candidate.place
    later = [each.trial for each in kept[at + 1 :] if place is not None and _alike(each.trial.candidate.place, place)]
    return max((_BESIDE_ANOTHER * each.gain for each in later), default=0.0)


def _beside_a_gap(first: Case, others: Case) -> Case:
    """Return the case without an effect, with its gap simulated without it too, where a gap is still told."""
    anew = gap_anew(others)
    return others if anew is None else replace(anew, left=unexplained(first.left, first, anew.model))


def _gap_of(case: Case) -> Candidate | None:
    return next((each for each in case.accepted if each.mechanism == GAP), None)


def _of_the_gap(kept: Sequence[Accepted]) -> float:
    """Return what an effect must take away beside a gap, whose own fit is only as good as its simulations."""
    return max((_BESIDE_A_GAP * each.trial.gain for each in kept if each.trial.candidate.mechanism == GAP), default=0.0)


def _alike(one: Place | None, other: Place) -> bool:
    return one is not None and one.domain == other.domain and abs(one.at - other.at) < SAME_ORDER


def _gain(trial: Trial, without: Calibrated, final: Calibrated) -> float:
    """Return what the misfit falls by with an effect beside all others, knobs paid."""
    return without.cost - final.cost - PER_KNOB * len(trial.candidate.knobs) - trial.candidate.price


def _rivals(taken: Accepted) -> frozenset[str]:
    """Return the mechanisms that explained some of it when an effect was taken; what did not can hardly replace it."""
    every = (*taken.tried.fitted, *taken.tried.screened)
    others = [each for each in every if _other(each, taken.trial)]
    return frozenset(each.candidate.mechanism for each in others if each.gain > _RIVALS * taken.trial.gain)


def _other(one: Trial, other: Trial) -> bool:
    return one.candidate.mechanism != other.candidate.mechanism


def _as_last(kept: Sequence[Accepted], model: Calibrated) -> Trial:
    """Return the last trial with the model that holds what is kept."""
    return replace(kept[-1].trial, model=model)


def _without(first: Case, accepted: Sequence[Accepted], index: int) -> Case:
    """Return the case with all effects but one, its numbers fitted again from where they stood."""
    candidates = [each.trial.candidate for row, each in enumerate(accepted) if row != index]
    bare = replace(first, accepted=tuple(candidates))
    rig, gone = bare.nominal_with_accepted(), {part.name for part in accepted[index].trial.candidate.parts}
    final = accepted[-1].trial.model
    rows = [row for row, knob in enumerate(final.knobs) if knob.part not in gone]
    knobs = tuple(final.knobs[row] for row in rows)
    corrections = None if accepted[index].trial.candidate.mechanism == GAP else final.corrections or None
    known = None if final.jacobian is None else final.jacobian[:, rows]

    def fitted(start: NDArray[np.float64]) -> Calibrated:
        return calibrated(rig, first.seen, knobs, start=start, corrections=corrections, jacobian=known)

    model = min(parallel_map(fitted, (final.positions[rows], np.zeros(len(knobs)))), key=lambda each: each.cost)
    return replace(bare, model=model, left=unexplained(first.left, first, model), apart=None)


def with_gap(accepted: Sequence[Accepted], gap: Candidate | None) -> list[Accepted]:
    """Return what was accepted, the gap in its new width where it has one."""
    if gap is None:
        return list(accepted)
    return [
        replace(each, trial=replace(each.trial, candidate=gap)) if each.trial.candidate.mechanism == GAP else each
        for each in accepted
    ]


def with_all(case: Case, accepted: Sequence[Accepted]) -> Case:
    """Return the case with the effects in its model."""
    for each in accepted:
        case = extended(case, each.trial)
    return case


def only(first: Case, accepted: Sequence[Accepted], gone: Accepted) -> tuple[Case, list[Accepted]]:
    """Return the case and the effects without one of them, the numbers fitted again."""
    case = _without(first, accepted, accepted.index(gone))
    kept = [each for each in accepted if each is not gone]
    if kept:
        kept[-1] = replace(kept[-1], trial=_as_last(kept, case.model))
    return (case if kept else first), kept
