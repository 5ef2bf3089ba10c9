"""Effect after effect, as long as one is clearly missing: what is found, its rivals, and which run would tell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from torquerig.diagnose.case import Case
from torquerig.diagnose.confidence import confidence
from torquerig.diagnose.diagnosis import Finding
from torquerig.diagnose.equivalence import equivalents
from torquerig.diagnose.explained import LEAST_SHARE, explained_share
from torquerig.diagnose.features import Features
from torquerig.diagnose.identifying import identifying
from torquerig.diagnose.next_run import next_run
from torquerig.diagnose.search import LEAST_GAIN, MOST_EFFECTS, Trial, Tried, extended, trials
from torquerig.diagnose.sentences import explanation
from torquerig.diagnose.set_aside import set_aside

Progress = Callable[[str], None]

_MOST_RIVALS = 3


@dataclass(frozen=True, kw_only=True)
class Searched:
    """What a search came to.

    Parameters
    ----------
    case : Case
        With all findings in its model.
    findings : tuple of Finding
    first, last : Tried
        What was tried on the calibrated nominal model, and on the last one, which found nothing more.
    """

    case: Case
    findings: tuple[Finding, ...]
    first: Tried
    last: Tried


def searched(case: Case, held: Sequence[Features], progress: Progress) -> Searched:
    """Add effects as long as one is clearly missing and explains its places."""
    findings: list[Finding] = []
    first: Tried | None = None
    while True:
        progress("trying the library's effects" if not findings else f"trying what {findings[-1].mechanism} leaves")
        tried = trials(case)
        first = first or tried
        good = [trial for trial in tried.fitted if _convincing(case, trial, findings)]
        if not good or len(findings) == MOST_EFFECTS:
            return Searched(case=case, findings=tuple(findings), first=first, last=tried)
        findings.append(_finding(case, good[0], tried.fitted, held))
        case = extended(case, good[0])


def reasons(case: Case, found: Searched, findings: Sequence[Finding]) -> Mapping[str, str]:
    """Return why each mechanism that is neither found nor was fitted in full was set aside; ``case`` is the first."""
    fitted = [trial.candidate.mechanism for trial in found.first.fitted]
    return set_aside(case, found.first.screened, fitted=fitted, found=[each.mechanism for each in findings])


def run_for_the_rest(found: Searched) -> str | None:
    """Return which run would tell between the hypotheses that explain part of what is left unexplained."""
    best: dict[str, Trial] = {}
    for trial in found.last.fitted:
        if trial.gain > LEAST_GAIN:
            best.setdefault(trial.candidate.mechanism, trial)
    advice = next_run(found.case, list(best.values())[:_MOST_RIVALS])
    return None if advice is None else advice.sentence()


def _convincing(case: Case, trial: Trial, earlier: Sequence[Finding]) -> bool:
    share = explained_share(case.model.misfits, trial.model.misfits)
    # an effect beyond the twin leaves small lines of its own, which are no effects
    least = max([LEAST_GAIN, *(0.25 * each.gain for each in earlier if case.model.corrections)])
    return trial.gain > least and share > LEAST_SHARE


def _finding(case: Case, best: Trial, tried: Sequence[Trial], held: Sequence[Features]) -> Finding:
    candidate = best.candidate
    parameters = identifying(candidate, best.model, case)
    share = explained_share(case.model.misfits, best.model.misfits)
    others: dict[str, float] = {}
    for trial in tried:
        if trial.candidate.mechanism != candidate.mechanism:
            others.setdefault(trial.candidate.mechanism, trial.gain)
    listed = tuple(others.items())
    alike = equivalents(case, best, tried, held)
    finding = Finding(
        mechanism=candidate.mechanism,
        variant=candidate.variant,
        explanation=explanation(candidate.mechanism, parameters, share=share, rivals=listed, gain=best.gain),
        confidence=confidence(gain=best.gain, share=share, rival=max(others.values(), default=0.0)),
        parameters=parameters,
        gain=best.gain,
        rivals=listed,
        equivalent_to=tuple(trial.candidate.mechanism for trial in alike),
    )
    if not alike:
        return finding
    advice = next_run(case, [best, *alike])
    return replace(finding, next_experiment="no run of the menu would tell" if advice is None else advice.sentence())
