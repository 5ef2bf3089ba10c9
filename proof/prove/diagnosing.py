"""Diagnosis and baseline verdicts of one rig, without access to answers."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.baselines.calibrated import Calibrated, by_likelihood
from proof.prove.trial_set import BASELINE_VERDICTS, COSTS, DIAGNOSES, REFUSED
from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.recordings.files import read_recording
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario
from torquerig.scenario.reading import read_scenario
from torquerig.whole_file import whole_file

SCENARIO = "wear_rig.yaml"


@dataclass(frozen=True, kw_only=True)
class DiagnosisJob:
    """Recordings of one rig, the folder of its diagnosis, and the names of the baselines to run."""

    name: str
    recordings: tuple[Path, ...]
    folder: Path
    baselines: tuple[str, ...] = ()


def job_of(name: str, recordings: Path, folder: Path, *, baselines: Sequence[str] = ()) -> DiagnosisJob:
    """Return the job for all tables of a folder of recordings."""
    tables = tuple(sorted(recordings.glob("*.parquet")))
    return DiagnosisJob(name=name, recordings=tables, folder=folder, baselines=tuple(baselines))


def is_diagnosed(job: DiagnosisJob) -> bool:
    """Return whether an earlier call wrote this diagnosis and its baselines, or the error instead."""
    if refusal_path(job.folder, DIAGNOSES, job.name).is_file():
        return True
    wanted = [job.folder / DIAGNOSES, *(job.folder / BASELINE_VERDICTS / one for one in job.baselines)]
    return all((folder / f"{job.name}.json").is_file() for folder in wanted)


def diagnosed(job: DiagnosisJob) -> str:
    """Diagnose one rig, write diagnosis, baselines and cost, and return its name.

    The diagnosis is written last and marks the case as finished.
    """
    try:
        started, worked = time.perf_counter(), time.process_time()
        outcome = diagnose(nominal_scenario(), read_all(job.recordings))
        found = as_json(outcome)
        cost = {
            "seconds": round(time.perf_counter() - started, 2),
            "processor_seconds": round(time.process_time() - worked, 2),
            "peak_MiB": round(_peak(), 1),
        }
        for name, said in baseline_verdicts(by_likelihood(outcome, found), job.baselines).items():
            write_json(job.folder / BASELINE_VERDICTS / name / f"{job.name}.json", said)
        write_json(job.folder / COSTS / f"{job.name}.json", cost)
        write_json(job.folder / DIAGNOSES / f"{job.name}.json", found)
    except Exception as wrong:
        refuse(job.folder, DIAGNOSES, job.name, wrong)
    return job.name


def baseline_verdicts(start: Calibrated, names: Sequence[str]) -> dict[str, dict[str, Any]]:
    """Return the verdicts of the baselines on the same calibrated nominal model."""
    from proof.baselines import BASELINES

    return {name: BASELINES[name](start) for name in names}


def nominal_scenario() -> Scenario:
    """Return the shipped wear rig, the nominal scenario of all trials."""
    path = shipped_scenarios() / SCENARIO
    return read_scenario(read_document(path), load_catalog(shipped_folder()), seed=0)


def read_all(paths: Sequence[Path]) -> list[Recording]:
    """Return the recordings of one rig."""
    return [read_recording(path) for path in paths]


def write_json(path: Path, data: Any) -> None:
    """Write a JSON file completely or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(path) as partial:
        partial.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def refuse(folder: Path, stage: str, name: str, wrong: Exception) -> None:
    """Write the error of a stage for a case."""
    path = refusal_path(folder, stage, name)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"{type(wrong).__name__}: {wrong}\n", encoding="utf-8")


def refusal_path(folder: Path, stage: str, name: str) -> Path:
    """Return the path of that error; delete the file to repeat the case."""
    return folder / REFUSED / f"{stage}-{name}.txt"


def _peak() -> float:
    """Return the peak memory of this process so far [MiB]; 0 if the system does not report it."""
    if sys.platform == "win32":
        return 0.0
    import resource

    held = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(held) / (1024.0**2 if sys.platform == "darwin" else 1024.0)
