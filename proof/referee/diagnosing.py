"""The command ``torquerig diagnose`` on one case, in a process of its own, with a time limit and without answers."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from proof.referee.making import BACKWARDS, RECORDINGS

DIAGNOSES, REFUSED, COSTS, REDUCED = "diagnoses", "refused", "costs", "reduced"
CHECKOUT = Path(__file__).resolve().parents[2]
SAME_NAME = {"gear_mesh": ("gear_mesh", "tooth_mesh")}  # files whose findings have one name in the contract


@dataclass(frozen=True)
class DiagnoseJob:
    """A case that is to be diagnosed.

    Parameters
    ----------
    name : str
    out : Path
        Folder of the round, with the recordings.
    without : str
        Mechanism whose file is removed, or empty.
    limit : float
        Time limit [s] on the clock.
    options : tuple of str
        Further options of ``torquerig diagnose``.
    label : str
        Folder of the results within that of the round, so that several versions share the recordings.
    """

    name: str
    out: Path
    without: str = ""
    limit: float = 600.0
    options: tuple[str, ...] = ()
    label: str = ""

    @property
    def results(self) -> Path:
        """Folder of diagnoses, refusals and costs."""
        return self.out / self.label


def is_diagnosed(job: DiagnoseJob) -> bool:
    """Return whether an earlier call has an answer or a refusal of the case."""
    return _answer(job).is_file() or _refusal(job).is_file()


def diagnosed(job: DiagnoseJob) -> str:
    """Call the command on a case and return its name; the cost is written first, then the answer or the refusal."""
    folder = job.out / RECORDINGS / job.name
    tables = sorted(folder.glob("run*.parquet"))
    if (folder / BACKWARDS).is_file():
        tables.reverse()
    answer = _answer(job)
    answer.parent.mkdir(parents=True, exist_ok=True)
    partial = answer.with_suffix(".part.json")
    files = [*map(str, tables), "--scenario", str(folder / "scenario.yaml"), "--json", str(partial)]
    words = [sys.executable, "-m", "torquerig", "diagnose", *files, "--workers", "1", *job.options]
    source = reduced_checkout(job.out, job.without) if job.without else CHECKOUT
    started = time.perf_counter()
    code, said, worked = _called(words, {"PYTHONPATH": str(source / "src")}, limit=job.limit)
    cost = {"seconds": round(time.perf_counter() - started, 2), "processor_seconds": round(worked, 2), "exit": code}
    _write(job.results / COSTS / f"{job.name}.json", json.dumps(cost))
    partial.with_suffix(".model.yaml").unlink(missing_ok=True)
    if code == 0 and partial.is_file():
        partial.replace(answer)
    else:
        partial.unlink(missing_ok=True)
        _write(_refusal(job), said)
    return job.name


def reduced_checkout(out: Path, mechanism: str) -> Path:
    """Return a copy of the program without the files that give a mechanism's name; made once."""
    where = out / REDUCED / mechanism
    package = where / "src" / "torquerig"
    if not package.is_dir():
        partial = where.with_name(f"{mechanism}.{os.getpid()}")
        shutil.copytree(
            CHECKOUT / "src" / "torquerig", partial / "src" / "torquerig", ignore=shutil.ignore_patterns("__pycache__")
        )
        for folder in ("catalogs", "scenarios"):
            shutil.copytree(CHECKOUT / folder, partial / folder)
        for file in SAME_NAME.get(mechanism, (mechanism,)):
            (partial / "src" / "torquerig" / "mechanisms" / f"{file}.py").unlink()
        try:
            partial.rename(where)
        except OSError:  # another worker was first
            shutil.rmtree(partial)
    return where


def _called(words: list[str], variables: dict[str, str], *, limit: float) -> tuple[int, str, float]:
    """Return exit code, last lines of what the command said, and its processor time [s]; -1 for the time limit."""
    before = os.times()
    one_thread = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MPLBACKEND": "Agg"}
    process = subprocess.Popen(  # noqa: S603 (this interpreter, on files that this program wrote)
        words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=os.environ | one_thread | variables,
        start_new_session=True,
    )  # fmt: skip
    try:
        said, _ = process.communicate(timeout=limit)
        code = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        code, said = -1, f"no answer within the limit of {limit:g} s\n"
    after = os.times()
    worked = after.children_user + after.children_system - before.children_user - before.children_system
    return code, said[-2000:] or f"exit code {code} and no message\n", worked


def _answer(job: DiagnoseJob) -> Path:
    return job.results / DIAGNOSES / f"{job.name}.json"


def _refusal(job: DiagnoseJob) -> Path:
    return job.results / REFUSED / f"{job.name}.txt"


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
