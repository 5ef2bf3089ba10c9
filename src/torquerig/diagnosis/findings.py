"""Effect after effect, as long as one is clearly missing: what is found, its rivals, and which run would tell."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from torquerig.diagnosis.advising.next_run import next_run
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.beginning_again import best_chain
from torquerig.diagnosis.choosing.chain import Chain, Progress, rest_of
from torquerig.diagnosis.choosing.confidence import SEEN_IN_SAMPLES, confidence_of, rivals_of
from torquerig.diagnosis.choosing.convincing import share_of
from torquerig.diagnosis.choosing.equivalence import equivalents
from torquerig.diagnosis.choosing.identifying import identifying
from torquerig.diagnosis.choosing.numbers_held import with_numbers_held
from torquerig.diagnosis.choosing.revising import Accepted
from torquerig.diagnosis.choosing.search import Tried
from torquerig.diagnosis.choosing.set_aside import set_aside
from torquerig.diagnosis.choosing.trial import LEAST_GAIN, Trial
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.neutral import in_words
from torquerig.diagnosis.outcome import Finding
from torquerig.diagnosis.sample_findings import SampleFindings
from torquerig.diagnosis.sentences import explanation

_MOST_RIVALS = 3
_TURNING_LINES = frozenset({"gear_mesh", "cogging", "commutation_ripple", "blade_pass"})
_OF_ONE_SIZE = _TURNING_LINES | {"pwm_aliasing"}  # lines that nothing but the speed and the load change


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
    accepted : tuple of Accepted
        What the findings and descriptions tell of.
    withdrawn : tuple of str
        Mechanisms that were found, and do not hold on what no fit has seen.
    instead : Searched or None
        What another beginning of the search came to, which missed more of what fits may see.
    numbers_held : bool
        Whether the model's own numbers stand as they stood before the findings.
    """

    case: Case
    findings: tuple[Finding, ...]
    descriptions: tuple[str, ...]
    first: Tried
    last: Tried
    accepted: tuple[Accepted, ...] = ()
    withdrawn: tuple[str, ...] = ()
    instead: Searched | None = None
    numbers_held: bool = False

    @property
    def all_lines(self) -> bool:
        """Whether all that was accepted sets out to explain a line."""
        return all(each.trial.candidate.place is not None for each in self.accepted)

    @property
    def turning_lines(self) -> bool:
        """Whether all that was accepted makes lines at orders, and nothing else."""
        return bool(self.accepted) and all(each.trial.candidate.mechanism in _TURNING_LINES for each in self.accepted)

    @property
    def lines_of_one_size(self) -> bool:
        """Whether all that was accepted makes lines whose size its cause tells of every run."""
        return bool(self.accepted) and all(each.trial.candidate.mechanism in _OF_ONE_SIZE for each in self.accepted)

    def in_turn(self, before: Case, held: Sequence[Features]) -> Iterator[Searched]:
        """Yield what is to be believed first, and what instead where that does not hold on what no fit has seen.

        The same effects beside the numbers as they stood before them, what another beginning came to, and at last none
        of them.
        """
        yield self
        if not self.accepted:
            return
        held_fast = with_numbers_held(before, self.case)
        if held_fast is not None:
            yield replace(_told(self, held_fast, held), numbers_held=True)
        if self.instead is not None and self.instead.accepted:
            yield self.instead
        yield self.all_withdrawn(before)

    def all_withdrawn(self, before: Case) -> Searched:
        """Return the outcome of a search that found nothing in the case ``before`` that holds."""
        names = tuple(each.mechanism for each in self.findings)
        return replace(self, case=before, findings=(), descriptions=(), accepted=(), last=self.first, withdrawn=names)


def searched(case: Case, held: Sequence[Features], progress: Progress) -> Searched:
    """Add effects as long as one is clearly missing and explains its places, then look back at each."""
    return _of_chain(best_chain(case, held, progress), held)


def faults_found(faults: SampleFindings, case: Case, *, gain: float) -> list[Finding]:
    """Return the faults of the samples as findings, which share what the held-out misfit fell by."""
    answer = []
    for candidate in faults.candidates:
        model = replace(case.model, rig=candidate.added_to(candidate.removed_from(case.model.rig)))
        parameters = identifying(candidate, model, case)
        said = explanation(candidate.mechanism, parameters, share=1.0, rivals=(), gain=0.0)
        finding = Finding(
            mechanism=candidate.mechanism, variant="", explanation=said, confidence=SEEN_IN_SAMPLES,
            parameters=parameters, gain=gain,
        )  # fmt: skip
        answer.append(finding)
    return answer


def reasons(case: Case, found: Searched, findings: Sequence[Finding], *, why: str) -> Mapping[str, str]:
    """Return why each mechanism that was neither found nor an alternative to what was is set aside.

    ``case`` is the first, and ``why`` the reason for what was withdrawn.
    """
    others = [name for each in findings for name, _ in each.alternatives]
    known = [each.mechanism for each in findings]
    aside = set_aside(case, found.first, known=[*known, *others])
    return {**aside, **{name: why for name in found.withdrawn if name not in known}}


def run_for_the_rest(found: Searched) -> str | None:
    """Return which run would tell between the hypotheses that explain part of what is left unexplained."""
    best: dict[str, Trial] = {}
    for trial in found.last.fitted:
        if trial.gain > LEAST_GAIN and not trial.candidate.description:
            best.setdefault(trial.candidate.mechanism, trial)
    advice = next_run(found.case, list(best.values())[:_MOST_RIVALS])
    return None if advice is None else advice.sentence()


def _of_chain(found: Chain, held: Sequence[Features]) -> Searched:
    """Return what a chain of effects came to, and what the one came to whose place it took."""
    plain = Searched(
        case=found.case, findings=(), descriptions=(), first=found.first, last=found.last, accepted=found.accepted,
        instead=None if found.instead is None else _of_chain(found.instead, held),
    )  # fmt: skip
    return _told(plain, found.case, held)


def _told(found: Searched, final: Case, held: Sequence[Features]) -> Searched:
    """Return the outcome with the accepted effects told by the numbers of the case ``final``."""
    named = [each for each in found.accepted if not each.trial.candidate.description]
    described = [each.trial.candidate for each in found.accepted if each.trial.candidate.description]
    return replace(
        found,
        case=final,
        findings=tuple(_finding(final, each, held) for each in named),
        descriptions=tuple(in_words(candidate, final.model.rig) for candidate in described),
    )


def _finding(final: Case, accepted: Accepted, held: Sequence[Features]) -> Finding:
    """Return the finding: its rivals as they stood when it was taken, its numbers as they stand in the final model."""
    case, best, tried = accepted.before, accepted.trial, accepted.tried.fitted
    candidate = best.candidate
    parameters = identifying(candidate, final.model, final)
    share = share_of(case, best)
    listed = tuple(rivals_of(final, accepted).items())
    rivals = [t for t in tried if not t.candidate.description and not final.has(t.candidate.mechanism)]
    alike = equivalents(best, rivals, held)
    finding = Finding(
        mechanism=candidate.mechanism,
        variant=candidate.variant,
        explanation=explanation(candidate.mechanism, parameters, share=share, rivals=listed, gain=best.gain),
        confidence=confidence_of(final, accepted),
        parameters=parameters,
        gain=best.gain,
        share=share,
        rest=rest_of(final, accepted),
        alternatives=listed,
        equivalent_to=tuple(trial.candidate.mechanism for trial in alike),
    )
    if not alike:
        return finding
    advice = next_run(case, [best, *alike])
    return replace(
        finding,
        next_experiment="None of the candidate runs distinguishes these mechanisms."
        if advice is None
        else advice.sentence(),
    )
