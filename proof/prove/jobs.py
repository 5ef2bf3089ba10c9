"""Jobs over worker processes by the case engine, with progress; a worker that dies costs its job a second try."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from typing import Any

from proof.errors import ProofError
from torquerig.cases import Case, ThisMachine, ThisProcess, answers

Progress = Callable[[int, int, str], None]


def no_progress(_done: int, _total: int, _name: str) -> None:
    """Show nothing."""


@dataclass(frozen=True)
class _Jobs:
    """What each worker gets once."""

    work: Callable[[Any], str]
    jobs: Sequence[Any]


def run_jobs(
    work: Callable[[Any], str], jobs: Sequence[Any], *, workers: int, progress: Progress = no_progress
) -> None:
    """Run ``work`` on every job; it returns the name for the progress. One worker runs in this process.

    Raises
    ------
    ProofError
        For the first job that has no answer: its work raised an error, or its worker died twice. All other jobs are
        run before.
    """
    if not jobs:
        return
    progress(0, len(jobs), "")
    engine = ThisProcess() if workers == 1 or len(jobs) < 2 else ThisMachine(workers)
    cases = [Case(number=number, values={}) for number in range(len(jobs))]
    without = []
    with closing(answers(_done, _Jobs(work, jobs), cases, engine=engine, block_size=1)) as arriving:
        for done, answer in enumerate(arriving, start=1):
            if answer.state == "done":
                progress(done, len(jobs), answer.value)
            else:
                without.append(f"{jobs[answer.case.number]}: {answer.error}")
    if without:
        raise ProofError(f"{len(without)} of {len(jobs)} jobs have no answer; the first is {without[0]}")


def _done(inputs: _Jobs, cases: Sequence[Case]) -> list[str]:
    return [inputs.work(inputs.jobs[case.number]) for case in cases]
