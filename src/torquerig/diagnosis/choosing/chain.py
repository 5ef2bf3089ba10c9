"""Effects taken one after the other, each looked back at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.around_gap import told_again
from torquerig.diagnosis.choosing.beside_gaps import chatter_outdone
from torquerig.diagnosis.choosing.confidence import LEAST as LEAST_CONFIDENCE
from torquerig.diagnosis.choosing.confidence import confidence_of
from torquerig.diagnosis.choosing.convincing import convincing, hopeful, promising, takes_much, worthiest
from torquerig.diagnosis.choosing.explained import (
    HARDLY_ANY,
    LARGEST_REST,
    LEAST_SHARE_WHERE_ALL_FITS,
    explained_share,
    left_at_its_places,
)
from torquerig.diagnosis.choosing.one_of_many import one_of_many
from torquerig.diagnosis.choosing.possible import can_be
from torquerig.diagnosis.choosing.revising import Accepted, only, revised, with_all, with_gap
from torquerig.diagnosis.choosing.search import MOST_EFFECTS, Tried, trials
from torquerig.diagnosis.choosing.secondary import small_beside, stands_in_simulations
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.diagnosis.looking.features import Features

Progress = Callable[[str], None]


@dataclass(frozen=True, kw_only=True)
class Chain:
    """Effects taken one after the other, what was tried first and last, and the case with them all.

    ``begun`` is what was taken first, whether or not the look back left it there, and ``instead`` the chain whose place
    this one took.
    """

    case: Case
    accepted: tuple[Accepted, ...]
    begun: Trial | None
    first: Tried
    last: Tried
    instead: Chain | None = None


def chained(
    start: Case, held: Sequence[Features], progress: Progress, *, first: Tried | None = None,
    begin: Trial | None = None, instead_of: str = "",
) -> Chain:  # fmt: skip
    """Return the effects that are found one after the other; ``begin`` is taken first, one of those tried ``first``.

    It ends where it comes to the mechanism ``instead_of`` which it was begun: it is no other chain.
    """
    case, accepted, on_trial, tried = start, list[Accepted](), _OnTrial(), first
    if begin is not None and first is not None:
        accepted = [Accepted(before=start, trial=begin, tried=first)]
        unsure, slow = not convincing(start, begin, earlier=[], held=held), begin.candidate.slow
        case, on_trial = with_all(start, accepted), _OnTrial(unsure, 2 if slow else 1, wholly=slow)
    while True:
        progress(
            "testing the mechanisms of the library"
            if not accepted
            else f"testing the residual after {_said(accepted[-1])}"
        )
        tried = trials(case)
        first = first or tried
        described = max((trial.gain for trial in tried.fitted if trial.candidate.description), default=0.0)
        good = [
            trial
            for trial in (*_around_gap(case, tried), *tried.fitted)
            if trial.gain >= described
            and convincing(case, trial, earlier=[each.trial for each in accepted], held=held)
            and not chatter_outdone(case, trial, tried.fitted)
        ]
        if not (good or accepted):  # where one does not suffice, two may
            good, on_trial = _half_right(case, tried)
        if not good or len(accepted) == MOST_EFFECTS:
            break
        of_each = {trial.candidate.mechanism: trial for trial in reversed(good)}  # the best of each, which come first
        best = worthiest(case, [*of_each.values()])
        in_doubt = small_beside(best, [each.trial for each in accepted]) or (accepted and best.candidate.description)
        if in_doubt and not stands_in_simulations(case, best):
            break
        accepted = [*with_gap(accepted, best.gap), Accepted(before=case, trial=best, tried=tried)]
        case = with_all(start, accepted)
        if best.candidate.mechanism == instead_of:
            return Chain(case=case, accepted=tuple(accepted), begun=begin, first=first, last=tried)
    if on_trial.yes and not _passed(on_trial, start, case, accepted):
        case, accepted = start, []
    begun = accepted[0].trial if accepted else None
    if len(accepted) > 1:
        progress("testing whether each finding is still needed")
        accepted = list(revised(start, accepted))
        case = with_all(start, accepted)
    while fallen := [each for each in accepted if not _stands(case, each)]:
        case, accepted = only(start, accepted, max(fallen, key=partial(rest_of, case)))
    return Chain(case=case, accepted=tuple(accepted), begun=begun, first=first, last=tried)


class _OnTrial(NamedTuple):
    """Whether what was taken first does not suffice alone, with how many it may, and if nothing may be left."""

    yes: bool = False
    fewest: int = 1
    wholly: bool = False


def _half_right(case: Case, tried: Tried) -> tuple[list[Trial], _OnTrial]:
    """Return what may be half of a pair where nothing suffices alone; a drift beside friction leaves levels wrong."""
    found = [trial for trial in tried.fitted if promising(case, trial)]
    fewest = 1 if any(not trial.candidate.resembled for trial in found) else 2  # noise looks like the others
    found = found or [trial for trial in tried.fitted if hopeful(case, trial)]
    if found:
        return found, _OnTrial(True, fewest)
    found = [trial for trial in tried.fitted if trial.candidate.slow and takes_much(case, trial)]
    return found, _OnTrial(bool(found), 2, wholly=True)


def _passed(on_trial: _OnTrial, first: Case, final: Case, accepted: Sequence[Accepted]) -> bool:
    """Whether effects of which the first was on trial are right together."""
    if len(accepted) < on_trial.fewest or (on_trial.wholly and mismatches(final)):
        return False
    return _together(first, final, accepted)


def _around_gap(case: Case, tried: Tried) -> list[Trial]:
    """Return the best trial beside a gap whose width is told again, where a gap was found and this explains much."""
    named = [trial for trial in tried.fitted if not trial.candidate.description]
    if not (case.model.corrections and named and promising(case, named[0])):
        return []
    again = told_again(case, named[0])
    return [] if again is None else [again]


def _together(first: Case, final: Case, accepted: Sequence[Accepted]) -> bool:
    """Whether effects of which none sufficed alone explain their places together, less of them where all fits."""
    beside = [each.trial.beside for each in accepted]
    flown = (sum(before for before, _ in beside), sum(after for _, after in beside))
    share = explained_share(first.model.misfits, final.model.misfits, beside=flown)
    return share > LEAST_SHARE or (share > LEAST_SHARE_WHERE_ALL_FITS and not mismatches(final))


def _stands(final: Case, accepted: Accepted) -> bool:
    """Whether an effect leaves its places right in the final model, with numbers such as can be, and is likely.

    And whether it is no small line among others of its kind that stay.
    """
    likely = bool(accepted.trial.candidate.description) or confidence_of(final, accepted) > LEAST_CONFIDENCE
    possible = can_be(accepted.trial.candidate, final.model)
    missed = rest_of(accepted.before, accepted)
    right = rest_of(final, accepted) < max(LARGEST_REST, HARDLY_ANY * missed)
    return likely and possible and right and not one_of_many(final, accepted.trial)


def rest_of(case: Case, accepted: Accepted) -> float:
    """Return the mean robust square that a case's model leaves of the slow torque at an effect's places [1]."""
    return left_at_its_places(accepted.before.model.misfits, accepted.trial.model.misfits, case.model.misfits)


def _said(accepted: Accepted) -> str:
    return accepted.trial.candidate.description or accepted.trial.candidate.mechanism
