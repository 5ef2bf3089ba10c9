"""What needs the opened answers: what the true mechanisms reach, and what the library gains where nothing is hidden."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.null_gains import as_rows, null_gains
from proof.oracle import oracle
from proof.prove.diagnosing import nominal_scenario, read_all, refusal_path, refuse, write_json
from proof.prove.trial_set import NULL, ORACLE, RECORDINGS
from torquerig.diagnosis.outcome import as_json


@dataclass(frozen=True, kw_only=True)
class OpenedJob:
    """One case with what its answer says: the mechanisms of the library that it has; none of them asks for gains."""

    name: str
    folder: Path
    true: tuple[str, ...]

    @property
    def stage(self) -> str:
        """The folder that its result goes into."""
        return ORACLE if self.true else NULL


def opened_jobs(answers: dict[str, Any], folder: Path, first: int | None = None) -> Iterator[OpenedJob]:
    """Yield what is still to be done of the ``first`` so many cases.

    Those that only have effects in no library have nothing to do. The order of the cases is drawn: the first ones are a
    fair sample.
    """
    for name, answer in sorted(answers.items())[:first]:
        true = tuple(row["mechanism"] for row in answer["effects"] if row["in_library"])
        job = OpenedJob(name=name, folder=folder, true=true)
        done = (folder / job.stage / f"{name}.json").is_file() or refusal_path(folder, job.stage, name).is_file()
        if (true or not answer["effects"]) and not done:
            yield job


def opened(job: OpenedJob) -> str:
    """Write the oracle's diagnosis, or the gains of the library on a clean rig, and give the case's name."""
    try:
        recordings = read_all(sorted((job.folder / RECORDINGS / job.name).glob("*.parquet")))
        if job.true:
            data: Any = as_json(oracle(nominal_scenario(), recordings, true=job.true))
        else:
            data = as_rows(null_gains(nominal_scenario(), recordings))
        write_json(job.folder / job.stage / f"{job.name}.json", data)
    except Exception as wrong:
        refuse(job.folder, job.stage, job.name, wrong)
    return job.name
