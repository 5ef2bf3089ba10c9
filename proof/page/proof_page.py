"""The whole page of the blind trials, from the scored sets."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from proof.page.cells import percent
from proof.page.confidence import calibration, improvement, reliability_picture
from proof.page.cost import cost
from proof.page.failures import failures
from proof.page.headline import baselines_compared, headline
from proof.page.page_file import ProofPage, write_proof
from proof.page.practice import practice
from proof.page.riddle import riddle
from proof.page.strata import laws_compared, parameters, strata
from proof.page.trial_sets import trial_sets
from proof.prove.campaign import ProofResults
from proof.prove.scored import OURS, ScoredSet
from proof.prove.trial_set import riddle_set
from proof.scoring.summary import Summary, summarise
from proof.scoring.trial import Trial
from torquerig.reporting.matrix.chapters import Chapter

TITLE = "Blind trials of the diagnosis"


@dataclass(frozen=True, kw_only=True)
class WrittenPages:
    """Paths of the pages, and the scores of the diagnosis."""

    html: Path
    markdown: Path
    summary: Summary


def write_pages(proved: ProofResults, *, more: tuple[Chapter, ...] = ()) -> WrittenPages:
    """Write proof.html and proof.md into the folder of results."""
    summaries = summaries_of(proved.blind)
    page = proof_page(proved, summaries, more=more)
    paths = [proved.plan.out / f"proof.{ending}" for ending in ("html", "md")]
    for path in paths:
        write_proof(page, path)
    return WrittenPages(html=paths[0], markdown=paths[1], summary=summaries[OURS])


def proof_page(proved: ProofResults, summaries: dict[str, Summary], *, more: tuple[Chapter, ...] = ()) -> ProofPage:
    """Return the page; ``more`` chapters come before the failures."""
    ours, trials = summaries[OURS], trials_of(proved.blind, OURS)
    chapters = [headline(ours)]
    chapters += [baselines_compared(summaries)] if len(summaries) > 1 else []
    chapters += [trial_sets(proved), strata(ours), parameters(ours), improvement(ours, trials), calibration(ours)]
    if proved.same_laws:
        chapters.append(laws_compared(ours, summarise(list(trials_of(proved.same_laws, OURS)))))
    if proved.riddle:
        chapters.append(riddle(proved.riddle, _wanders(proved)))
    if proved.practice is not None:
        chapters.append(practice(proved.practice))
    costs = [one for each in proved.blind for one in each.costs]
    refusals = {name: why for each in proved.blind for name, why in each.refusals.items()}
    chapters += [*more, cost(costs, workers=proved.plan.workers, duration=proved.plan.duration)]
    chapters.append(failures(trials, refusals))
    pictures = {"calibration": reliability_picture(ours)}
    return ProofPage(
        title=TITLE, lead=lead(proved, ours), chapters=tuple(chapters), pictures=pictures, command=proved.plan.command
    )


def lead(proved: ProofResults, ours: Summary) -> tuple[str, ...]:
    """Return the main scores."""
    exact, within = ours.groups["all"]["all"]
    first = (
        f"{exact.hits} of {exact.trials} blind trials are exactly right ({percent(exact.hits / max(exact.trials, 1))}; "
        f"at least {percent(exact.lower)} with 95 % confidence), and {within.hits} exactly or within the class."
    )
    second = (
        f"{ours.false_names.hits} trials have a false name; {ours.false_on_blank.hits} of them are among the "
        f"{ours.false_on_blank.trials} rigs without hidden effects."
    )
    return (first, second)


def summaries_of(sets: tuple[ScoredSet, ...]) -> dict[str, Summary]:
    """Return the scores of every method over all sets."""
    return {method: summarise(list(trials_of(sets, method))) for method in sets[0].trials}


def trials_of(sets: tuple[ScoredSet, ...], method: str) -> tuple[Trial, ...]:
    """Return the trials of one method over all sets."""
    return tuple(trial for one in sets for trial in one.trials[method])


def _wanders(proved: ProofResults) -> dict[str, bool]:
    sets = [riddle_set(seed, proved.plan.out, duration=proved.plan.duration) for seed in proved.plan.seeds]
    return {f"{one.name}, {case.name}": case.wanders for one in sets for case in one.cases}
