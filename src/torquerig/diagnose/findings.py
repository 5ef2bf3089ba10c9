"""Effect after effect, as long as one is clearly missing: what is found, its rivals, and which run would tell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from torquerig.diagnose.advising.next_run import next_run
from torquerig.diagnose.case import Case
from torquerig.diagnose.choosing.around_gap import told_again, with_gap
from torquerig.diagnose.choosing.confidence import confidence
from torquerig.diagnose.choosing.convincing import convincing, promising, share_of, worth
from torquerig.diagnose.choosing.equivalence import equivalents
from torquerig.diagnose.choosing.explained import (
    LARGEST_REST,
    LEAST_SHARE,
    LEAST_SHARE_WHERE_ALL_FITS,
    explained_share,
    left_at_its_places,
)
from torquerig.diagnose.choosing.identifying import identifying
from torquerig.diagnose.choosing.revising import Accepted, only, revised, with_all
from torquerig.diagnose.choosing.search import LEAST_GAIN, MOST_EFFECTS, Trial, Tried, excess, trials
from torquerig.diagnose.choosing.set_aside import set_aside
from torquerig.diagnose.diagnosis import Finding
from torquerig.diagnose.hypotheses import is_possible
from torquerig.diagnose.judging.leftover import detail_of, mismatches
from torquerig.diagnose.looking.features import Features
from torquerig.diagnose.neutral import in_words
from torquerig.diagnose.sentences import explanation

Progress = Callable[[str], None]

_MOST_RIVALS = 3
_MUCH_LESS = 0.5  # of what a chain leaves, another that begins elsewhere may leave


@dataclass(frozen=True, kw_only=True)
class Searched:
    """What a search came to.

    Parameters
    ----------
    case : Case
        With all findings in its model.
    findings : tuple of Finding
    descriptions : tuple of str
        Of what was modelled without a name, in words.
    first, last : Tried
        What was tried on the calibrated nominal model, and on the last one, which found nothing more.
    """

    case: Case
    findings: tuple[Finding, ...]
    descriptions: tuple[str, ...]
    first: Tried
    last: Tried


def searched(case: Case, held: Sequence[Features], progress: Progress) -> Searched:
    """Add effects as long as one is clearly missing and explains its places, then look back at each.

    Where that ends in a model that is still wrong, it is begun again with the best rival of what was taken first, which
    may have stood in for two effects together. A model that does without what was taken first, and leaves less than
    half of what that one leaves, takes its place.
    """
    found = _chain(case, held, progress)
    rival = _rival_of_first(case, found)
    if rival is not None:
        progress(f"beginning again with {rival.candidate.mechanism}")
        other = _chain(case, held, progress, first=found.first, begin=rival)
        found = other if _replaces(other, found) else found
    named = [each for each in found.accepted if not each.trial.candidate.description]
    return Searched(
        case=found.case,
        findings=tuple(_finding(found.case, each, held) for each in named),
        descriptions=tuple(
            in_words(each.trial.candidate, found.case.model.rig)
            for each in found.accepted
            if each.trial.candidate.description
        ),
        first=found.first,
        last=found.last,
    )


@dataclass(frozen=True, kw_only=True)
class _Chain:
    """Effects taken one after the other, what was tried first and last, and the case with them all."""

    case: Case
    accepted: tuple[Accepted, ...]
    first: Tried
    last: Tried


def _chain(
    start: Case, held: Sequence[Features], progress: Progress, *, first: Tried | None = None, begin: Trial | None = None
) -> _Chain:
    """Return the effects that are found one after the other; ``begin`` is taken first, one of those tried ``first``."""
    case, accepted, on_trial, tried = start, list[Accepted](), False, first
    if begin is not None and first is not None:
        accepted = [Accepted(before=start, trial=begin, tried=first)]
        case, on_trial = with_all(start, accepted), not convincing(start, begin, earlier=[], held=held)
    while True:
        progress("trying the library's effects" if not accepted else f"trying what {_said(accepted[-1])} leaves")
        tried = trials(case)
        first = first or tried
        described = max((trial.gain for trial in tried.fitted if trial.candidate.description), default=0.0)
        good = [
            trial
            for trial in (*_around_gap(case, tried), *tried.fitted)
            if trial.gain >= described and convincing(case, trial, earlier=[each.trial for each in accepted], held=held)
        ]
        if not (good or accepted):  # where one does not suffice, two may
            good = [trial for trial in tried.fitted if promising(case, trial)]
            on_trial = bool(good)
        if not good or len(accepted) == MOST_EFFECTS:
            break
        of_each = {trial.candidate.mechanism: trial for trial in reversed(good)}  # the best of each, which come first
        best = max(of_each.values(), key=partial(worth, case))
        accepted = [*with_gap(accepted, best.gap), Accepted(before=case, trial=best, tried=tried)]
        case = with_all(start, accepted)
    if on_trial and not _together(start, case, accepted):
        case, accepted = start, []
    if len(accepted) > 1:
        progress("asking of each effect whether the others need it")
        accepted = list(revised(start, accepted))
        case = with_all(start, accepted)
    while fallen := [each for each in accepted if not _stands(case, each)]:
        case, accepted = only(start, accepted, max(fallen, key=partial(_rest, case)))
    return _Chain(case=case, accepted=tuple(accepted), first=first, last=tried)


def _rival_of_first(case: Case, found: _Chain) -> Trial | None:
    """Return the best rival of the effect that was taken first, where the model is still wrong with all of them."""
    left = mismatches(found.case)
    if not (found.accepted and left) or detail_of(case, found.case, left) is not None:
        return None
    taken = {each.trial.candidate.mechanism for each in found.accepted}
    rivals = [
        trial for trial in found.first.fitted if trial.candidate.mechanism not in taken and promising(case, trial)
    ]
    return max(rivals, key=lambda trial: trial.gain, default=None)


def _replaces(other: _Chain, found: _Chain) -> bool:
    """Whether another chain does without what was taken first, and does much better."""
    stood_in = found.accepted[0].trial.candidate.mechanism
    without = all(each.trial.candidate.mechanism != stood_in for each in other.accepted)
    return bool(other.accepted) and without and excess(other.case) < _MUCH_LESS * excess(found.case)


def _around_gap(case: Case, tried: Tried) -> list[Trial]:
    """Return the best trial beside a gap whose width is told again, where a gap was found and this explains much."""
    named = [trial for trial in tried.fitted if not trial.candidate.description]
    if not (case.model.corrections and named and promising(case, named[0])):
        return []
    again = told_again(case, named[0])
    return [] if again is None else [again]


def reasons(case: Case, found: Searched, findings: Sequence[Finding]) -> Mapping[str, str]:
    """Return why each mechanism that is neither found nor a rival of what is was set aside; ``case`` is the first."""
    rivals = [name for each in findings for name, _ in each.rivals]
    return set_aside(case, found.first, known=[*(each.mechanism for each in findings), *rivals])


def run_for_the_rest(found: Searched) -> str | None:
    """Return which run would tell between the hypotheses that explain part of what is left unexplained."""
    best: dict[str, Trial] = {}
    for trial in found.last.fitted:
        if trial.gain > LEAST_GAIN and not trial.candidate.description:
            best.setdefault(trial.candidate.mechanism, trial)
    advice = next_run(found.case, list(best.values())[:_MOST_RIVALS])
    return None if advice is None else advice.sentence()


def _rest(final: Case, accepted: Accepted) -> float:
    return left_at_its_places(accepted.before.model.misfits, accepted.trial.model.misfits, final.model.misfits)


def _stands(final: Case, accepted: Accepted) -> bool:
    """Whether an effect leaves its places right in the final model, with numbers such as can be."""
    return _rest(final, accepted) < LARGEST_REST and is_possible(accepted.trial.candidate, final.model.rig)


def _together(first: Case, final: Case, accepted: Sequence[Accepted]) -> bool:
    """Whether effects of which none sufficed alone explain their places together, less of them where all fits."""
    beside = [each.trial.beside for each in accepted]
    flown = (sum(before for before, _ in beside), sum(after for _, after in beside))
    share = explained_share(first.model.misfits, final.model.misfits, beside=flown)
    return share > LEAST_SHARE or (share > LEAST_SHARE_WHERE_ALL_FITS and not mismatches(final))


def _said(accepted: Accepted) -> str:
    return accepted.trial.candidate.description or accepted.trial.candidate.mechanism


def _finding(final: Case, accepted: Accepted, held: Sequence[Features]) -> Finding:
    """Return the finding: its rivals as they stood when it was taken, its numbers as they stand in the final model."""
    case, best, tried = accepted.before, accepted.trial, accepted.tried.fitted
    candidate = best.candidate
    parameters = identifying(candidate, final.model, final)
    share = share_of(case, best)
    others: dict[str, float] = {}
    for trial in tried:
        if trial.candidate.mechanism != candidate.mechanism and not final.has(trial.candidate.mechanism):
            others.setdefault(trial.candidate.mechanism, trial.gain)
    listed = tuple(others.items())
    rivals = [t for t in tried if not t.candidate.description and not final.has(t.candidate.mechanism)]
    alike = equivalents(best, rivals, held)
    finding = Finding(
        mechanism=candidate.mechanism,
        variant=candidate.variant,
        explanation=explanation(candidate.mechanism, parameters, share=share, rivals=listed, gain=best.gain),
        confidence=confidence(gain=best.gain, share=share, rival=max(others.values(), default=0.0)),
        parameters=parameters,
        gain=best.gain,
        share=share,
        rest=_rest(final, accepted),
        rivals=listed,
        equivalent_to=tuple(trial.candidate.mechanism for trial in alike),
    )
    if not alike:
        return finding
    advice = next_run(case, [best, *alike])
    return replace(finding, next_experiment="no run of the menu would tell" if advice is None else advice.sentence())
