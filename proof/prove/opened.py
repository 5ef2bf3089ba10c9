"""The stage that needs the opened answers: the oracle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.library import library_of
from proof.prove.diagnosing import nominal_scenario, read_all, refusal_path, refuse, write_json
from proof.prove.trial_set import ORACLE, RECORDINGS
from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class OpenedJob:
    """One case with its true mechanisms of the library."""

    name: str
    folder: Path
    true: tuple[str, ...]


def opened_jobs(answers: dict[str, Any], folder: Path, first: int | None = None) -> Iterator[OpenedJob]:
    """Yield the unfinished jobs of the ``first`` cases.

    Cases with effects outside the library only have none. The order of the cases is random, so that the first ones are
    a fair sample.
    """
    for name, answer in sorted(answers.items())[:first]:
        true = tuple(row["mechanism"] for row in answer["effects"] if row["in_library"])
        job = OpenedJob(name=name, folder=folder, true=true)
        done = (folder / ORACLE / f"{name}.json").is_file() or refusal_path(folder, ORACLE, name).is_file()
        if true and not done:
            yield job


def opened(job: OpenedJob) -> str:
    """Write the oracle's diagnosis, and return the case's name."""
    try:
        recordings = read_all(sorted((job.folder / RECORDINGS / job.name).glob("*.parquet")))
        made = _oracle(job, recordings)
        write_json(job.folder / ORACLE / f"{job.name}.json", made)
    except Exception as wrong:
        refuse(job.folder, ORACLE, job.name, wrong)
    return job.name


def _oracle(job: OpenedJob, recordings: list[Recording]) -> Any:
    """Return the diagnosis with a library of the true mechanisms only; one that is not likely enough is not forced."""
    from torquerig.inference.answer import as_json
    from torquerig.inference.engine import diagnose

    with library_of(job.true):
        return as_json(diagnose(nominal_scenario(), recordings))
