"""All stages in order: seal the answers, record, diagnose, and then open the answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from proof.prove.diagnosing import DiagnosisJob, diagnosed, is_diagnosed, job_of
from proof.prove.jobs import Progress, run_jobs
from proof.prove.opened import opened, opened_jobs
from proof.prove.plan import Plan
from proof.prove.practice import practice_answers, practice_cases
from proof.prove.scored import ScoredSet, recordings_of, scored
from proof.prove.trial_set import (
    TrialSet,
    blind_set,
    is_recorded,
    recorded,
    riddle_set,
    same_laws_set,
    sealed_digest,
)
from proof.sealed import unseal

Stage = Callable[[str], Progress]
Report = Callable[[str], None]


@dataclass(frozen=True, kw_only=True)
class ProofResults:
    """All sets of trials with open answers; ``practice`` and ``riddle`` are optional."""

    plan: Plan
    blind: tuple[ScoredSet, ...]
    same_laws: tuple[ScoredSet, ...] = ()
    riddle: tuple[ScoredSet, ...] = ()
    practice: ScoredSet | None = None


def prove(plan: Plan, *, report: Report, stage: Stage) -> ProofResults:
    """Seal, record and diagnose all trials, open the answers and return the outcomes.

    Parameters
    ----------
    report : callable
        Takes a line for the terminal; the seals are reported before the first diagnosis.
    stage : callable
        Returns the progress of a stage by its name.
    """
    practice = list(_practice_jobs(plan))  # first, to detect a wrong folder early
    blind = [blind_set(seed, plan.cases, plan.out, duration=plan.duration) for seed in plan.seeds]
    same = [same_laws_set(s, plan.cases, plan.out, duration=plan.duration) for s in plan.seeds if plan.same_laws]
    riddles = [riddle_set(seed, plan.out, duration=plan.duration) for seed in plan.seeds if plan.riddle]
    sets = [*blind, *same, *riddles]
    seals = {trials.name: sealed_digest(trials) for trials in sets}
    for name, digest in seals.items():
        report(f"{name}: answers sealed, SHA-256 {digest}")
    missing = [
        (case, trials.folder) for trials in sets for case in trials.cases if not is_recorded(case, trials)
    ]  # fmt: skip
    if missing:
        run_jobs(recorded, missing, workers=plan.workers, progress=stage("recording"))
    names = baseline_names()
    _diagnose_all(
        plan,
        [*_jobs(blind, names), *_jobs([*same, *riddles], ()), *practice],
        stage,
    )
    answers = {trials.name: unseal(trials.folder) for trials in sets}
    later = [job for trials in blind for job in opened_jobs(answers[trials.name], trials.folder, plan.oracle_cases)]
    if later:
        run_jobs(opened, later, workers=plan.workers, progress=stage("oracle"))

    def judged(some: Sequence[TrialSet], baselines: Sequence[str]) -> tuple[ScoredSet, ...]:
        return tuple(
            scored(one.name, one.folder, answers[one.name], seal=seals[one.name], baselines=baselines) for one in some
        )

    return ProofResults(plan=plan, blind=judged(blind, names), same_laws=judged(same, ()), riddle=judged(riddles, ()),
                  practice=_practice(plan))  # fmt: skip


def baseline_names() -> tuple[str, ...]:
    """Return the names of the baselines."""
    from proof.baselines import BASELINES

    return tuple(BASELINES)


def _jobs(sets: Iterable[TrialSet], baselines: Sequence[str]) -> Iterable[DiagnosisJob]:
    for trials in sets:
        for case in trials.cases:
            where = recordings_of(trials.folder, case.name)
            yield job_of(case.name, where, trials.folder, baselines=baselines)


def _practice_jobs(plan: Plan) -> Iterable[DiagnosisJob]:
    if plan.practice is not None:
        for name, where in practice_cases(plan.practice).items():
            yield job_of(name, where, _practice_folder(plan))


def _diagnose_all(plan: Plan, jobs: Sequence[DiagnosisJob], stage: Stage) -> None:
    """Diagnose the cases that no earlier call has finished."""
    remaining = [job for job in jobs if not is_diagnosed(job)]
    run_jobs(diagnosed, remaining, workers=plan.workers, progress=stage("diagnosing"))


def _practice(plan: Plan) -> ScoredSet | None:
    if plan.practice is None:
        return None
    return scored("practice", _practice_folder(plan), practice_answers(plan.practice), seal="")


def _practice_folder(plan: Plan) -> Path:
    return plan.out / "practice"
