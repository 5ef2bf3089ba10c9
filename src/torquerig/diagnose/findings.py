"""Effect after effect, as long as one is clearly missing: what is found, its rivals, and which run would tell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from torquerig.diagnose.calibration import misfits_of
from torquerig.diagnose.case import Case
from torquerig.diagnose.confidence import confidence
from torquerig.diagnose.diagnosis import Finding
from torquerig.diagnose.equivalence import equivalents
from torquerig.diagnose.explained import (
    LARGEST_REST,
    LEAST_SHARE,
    LEAST_SHARE_WHERE_ALL_FITS,
    explained_share,
    left_at_its_places,
)
from torquerig.diagnose.features import Features
from torquerig.diagnose.identifying import identifying
from torquerig.diagnose.leftover import mismatches
from torquerig.diagnose.misfit import misfit_sum
from torquerig.diagnose.neutral import in_words
from torquerig.diagnose.next_run import next_run
from torquerig.diagnose.revising import Accepted, only, revised, with_all
from torquerig.diagnose.search import LEAST_GAIN, MOST_EFFECTS, Trial, Tried, trials
from torquerig.diagnose.sentences import explanation
from torquerig.diagnose.set_aside import set_aside

Progress = Callable[[str], None]

_MOST_RIVALS = 3
_LARGE = (
    100.0  # gain above which the smaller share is enough where the model fits as a whole; chosen on development seeds
)


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
    """Add effects as long as one is clearly missing and explains its places, then look back at each."""
    start, accepted, first = case, list[Accepted](), None
    while True:
        progress("trying the library's effects" if not accepted else f"trying what {_said(accepted[-1])} leaves")
        tried = trials(case)
        first = first or tried
        described = max((trial.gain for trial in tried.fitted if trial.candidate.description), default=0.0)
        good = [trial for trial in tried.fitted if trial.gain >= described and _convincing(case, trial, accepted, held)]
        if not good or len(accepted) == MOST_EFFECTS:
            break
        accepted.append(Accepted(before=case, trial=good[0], tried=tried))
        case = with_all(start, accepted)
    if len(accepted) > 1:
        progress("asking of each effect whether the others need it")
        kept = revised(start, accepted)
        case = with_all(start, kept)
        accepted = list(kept)
    while accepted and (worst := max(accepted, key=lambda each: _rest(case, each))):
        if _rest(case, worst) < LARGEST_REST:
            break
        case, accepted = only(start, accepted, worst)
    named = [each for each in accepted if not each.trial.candidate.description]
    return Searched(
        case=case,
        findings=tuple(_finding(case, each, held) for each in named),
        descriptions=tuple(
            in_words(each.trial.candidate, case.model.rig) for each in accepted if each.trial.candidate.description
        ),
        first=first,
        last=tried,
    )


def reasons(case: Case, found: Searched, findings: Sequence[Finding]) -> Mapping[str, str]:
    """Return why each mechanism that is neither found nor was fitted in full was set aside; ``case`` is the first."""
    return set_aside(case, found.first, found=[each.mechanism for each in findings])


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


def _said(accepted: Accepted) -> str:
    return accepted.trial.candidate.description or accepted.trial.candidate.mechanism


def _convincing(case: Case, trial: Trial, earlier: Sequence[Accepted], held: Sequence[Features]) -> bool:
    if trial.candidate.description and not mismatches(case):
        return False  # what does not stand out needs no description
    share = explained_share(case.model.misfits, trial.model.misfits)
    # an effect beyond the twin leaves small lines of its own, which are no effects
    least = max([LEAST_GAIN, *(0.25 * each.trial.gain for each in earlier if case.model.corrections)])
    fits = trial.gain > _LARGE and trial.model.cost < sum(misfit.seen for misfit in trial.model.misfits)
    enough = LEAST_SHARE_WHERE_ALL_FITS if fits else LEAST_SHARE
    return trial.gain > least and share > enough and _foretells(case, trial, held)


def _foretells(case: Case, trial: Trial, held: Sequence[Features]) -> bool:
    """Whether what no fit has seen is foretold no worse with the effect; beyond the twin only simulations can tell."""
    if trial.model.corrections or case.model.corrections:
        return True
    return misfit_sum(misfits_of(trial.model.rig, held)) <= misfit_sum(misfits_of(case.model.rig, held))


def _finding(final: Case, accepted: Accepted, held: Sequence[Features]) -> Finding:
    """Return the finding: its rivals as they stood when it was taken, its numbers as they stand in the final model."""
    case, best, tried = accepted.before, accepted.trial, accepted.tried.fitted
    candidate = best.candidate
    parameters = identifying(candidate, final.model, final)
    share = explained_share(case.model.misfits, best.model.misfits)
    others: dict[str, float] = {}
    for trial in tried:
        if trial.candidate.mechanism != candidate.mechanism:
            others.setdefault(trial.candidate.mechanism, trial.gain)
    listed = tuple(others.items())
    alike = equivalents(case, best, [trial for trial in tried if not trial.candidate.description], held)
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
