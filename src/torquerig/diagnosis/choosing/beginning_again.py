"""Another chain of effects, begun with a rival of what was taken first, which may have stood in for two together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.chain import Chain, Progress, chained
from torquerig.diagnosis.choosing.convincing import promising, takes_much
from torquerig.diagnosis.choosing.opened_gap import GAP
from torquerig.diagnosis.choosing.search import excess
from torquerig.diagnosis.choosing.trial import PER_KNOB, Trial
from torquerig.diagnosis.judging.leftover import detail_of, mismatches
from torquerig.diagnosis.looking.features import Features

_MUCH_LESS = 0.5  # of what a chain leaves, another that begins elsewhere may leave


def best_chain(case: Case, held: Sequence[Features], progress: Progress) -> Chain:
    """Return the effects that are found one after the other, each looked back at.

    Where that ends in a model that is still wrong, it is begun again with the best rival of what was taken first. A
    model that does without what was taken first, and leaves less than half of what that one leaves, takes its place.

    So it is where a gap was taken first and another effect beside it: what simulations say of a gap bends with every
    line and every band, so that a gap and half of a pair may look like the pair. A model without the gap takes the
    place where it misses less, all its numbers paid.

    Where nothing is found at all, and a zero that drifts would take more away than what was then taken for half of a
    pair, it is begun again with the drift: beside friction it leaves levels wrong, and what bends in their place gains
    less than it.
    """
    found = chained(case, held, progress)
    found = _with_the_slow_half(found, case, held, progress)
    return _without_a_stand_in(found, case, held, progress)


def _with_the_slow_half(found: Chain, case: Case, held: Sequence[Features], progress: Progress) -> Chain:
    slow = _slow_half(case, found)
    if slow is None:
        return found
    progress(f"restarting the search with {slow.candidate.mechanism}")
    other = chained(case, held, progress, first=found.first, begin=slow)
    return other if other.accepted else found


def _without_a_stand_in(found: Chain, case: Case, held: Sequence[Features], progress: Progress) -> Chain:
    wrong = _still_wrong(case, found)
    rival = _rival_of_first(case, found, among_taken=not wrong) if wrong or _beside_gap(found) else None
    if rival is None:
        return found
    progress(f"restarting the search with {rival.candidate.mechanism}")
    other = chained(case, held, progress, first=found.first, begin=rival, instead_of=_begun_with(found))
    better = _leaves_much_less(other, found) if wrong else _misses_less(other, found)
    return replace(other, instead=found) if better and _without_first(other, found) else found


def _slow_half(case: Case, found: Chain) -> Trial | None:
    """Return what is slow and takes much, more than all that is promising by itself, where nothing was found."""
    if found.accepted:
        return None
    by_itself = _promising(case, found)
    slow = [trial for trial in found.first.fitted if trial.candidate.slow and takes_much(case, trial)]
    best, most = max(slow, key=_gain, default=None), max(by_itself, key=_gain, default=None)
    return best if best is not None and most is not None and best.gain > most.gain else None


def _promising(case: Case, found: Chain) -> list[Trial]:
    return [trial for trial in found.first.fitted if promising(case, trial)]


def _gain(trial: Trial) -> float:
    return trial.gain


def _still_wrong(case: Case, found: Chain) -> bool:
    """Whether a chain ends in a model that is wrong by more than the details of what it holds."""
    left = mismatches(found.case)
    return bool(left) and detail_of(case, found.case, left) is None


def _beside_gap(found: Chain) -> bool:
    return _begun_with(found) == GAP and len(found.accepted) > 1


def _rival_of_first(case: Case, found: Chain, *, among_taken: bool) -> Trial | None:
    """Return the best rival of the effect that was taken first, what was taken beside it among them or not."""
    if found.begun is None:
        return None
    taken = {found.begun.candidate.mechanism}
    if not among_taken:
        taken |= {each.trial.candidate.mechanism for each in found.accepted}
    rivals = [trial for trial in _promising(case, found) if trial.candidate.mechanism not in taken]
    return max(rivals, key=_gain, default=None)


def _begun_with(chain: Chain) -> str:
    return "" if chain.begun is None else chain.begun.candidate.mechanism


def _without_first(other: Chain, found: Chain) -> bool:
    return bool(other.accepted) and all(each.trial.candidate.mechanism != _begun_with(found) for each in other.accepted)


def _leaves_much_less(other: Chain, found: Chain) -> bool:
    return excess(other.case) < _MUCH_LESS * excess(found.case)


def _misses_less(other: Chain, found: Chain) -> bool:
    return other.case.model.cost + _paid(other) < found.case.model.cost + _paid(found)


def _paid(chain: Chain) -> float:
    candidates = [each.trial.candidate for each in chain.accepted]
    return sum(PER_KNOB * len(candidate.knobs) + candidate.price for candidate in candidates)
