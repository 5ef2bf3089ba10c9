"""Stages that need the opened answers: the oracle, and the gains on rigs without hidden effects."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.library import library_of
from proof.prove.diagnosing import nominal_scenario, read_all, refusal_path, refuse, write_json
from proof.prove.trial_set import NULL, ORACLE, RECORDINGS
from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class OpenedJob:
    """One case with its true mechanisms of the library; without any, the first engine computes its gains."""

    name: str
    folder: Path
    true: tuple[str, ...]
    engine: str = "rules"

    @property
    def stage(self) -> str:
        """Folder of the result."""
        return ORACLE if self.true else NULL


def opened_jobs(
    answers: dict[str, Any], folder: Path, first: int | None = None, *, engine: str = "rules"
) -> Iterator[OpenedJob]:
    """Yield the unfinished jobs of the ``first`` cases.

    Cases with effects outside the library only have none. The order of the cases is random, so that the first ones are
    a fair sample. The likelihood needs no gains of clean rigs: it has no thresholds.
    """
    for name, answer in sorted(answers.items())[:first]:
        true = tuple(row["mechanism"] for row in answer["effects"] if row["in_library"])
        job = OpenedJob(name=name, folder=folder, true=true, engine=engine)
        done = (folder / job.stage / f"{name}.json").is_file() or refusal_path(folder, job.stage, name).is_file()
        if (true or (engine == "rules" and not answer["effects"])) and not done:
            yield job


def opened(job: OpenedJob) -> str:
    """Write the oracle's diagnosis, or the gains on a clean rig, and return the case's name."""
    try:
        recordings = read_all(sorted((job.folder / RECORDINGS / job.name).glob("*.parquet")))
        made = _by_rules(job, recordings) if job.engine == "rules" else _by_likelihood(job, recordings)
        write_json(job.folder / job.stage / f"{job.name}.json", made)
    except Exception as wrong:
        refuse(job.folder, job.stage, job.name, wrong)
    return job.name


def _by_rules(job: OpenedJob, recordings: list[Recording]) -> Any:
    from proof.null_gains import as_rows, null_gains
    from proof.oracle import oracle
    from torquerig.diagnosis.outcome import as_json

    if job.true:
        return as_json(oracle(nominal_scenario(), recordings, true=job.true))
    return as_rows(null_gains(nominal_scenario(), recordings))


def _by_likelihood(job: OpenedJob, recordings: list[Recording]) -> Any:
    """Return the diagnosis with a library of the true mechanisms only; one that is not likely enough is not forced."""
    from torquerig.inference.answer import as_json
    from torquerig.inference.engine import diagnose

    with library_of(job.true):
        return as_json(diagnose(nominal_scenario(), recordings))
