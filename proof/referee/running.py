"""A round: make and seal the cases, diagnose them on the case engine, judge the answers and write the page."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.errors import ProofError
from proof.prove.jobs import Progress, run_jobs
from proof.referee.claims import read_claim
from proof.referee.diagnosing import DIAGNOSES, REFUSED, DiagnoseJob, diagnosed, is_diagnosed
from proof.referee.invariance import CHANGES
from proof.referee.judging import Verdict, judged
from proof.referee.making import ANSWERS, MakeJob, is_made, made
from proof.referee.page import Written, write_page
from proof.referee.sets import SETS

Stage = Callable[[str], Progress]
SEAL = "seal.txt"
QUICK = 10  # the quick round has one case in ten
STRIDE = 7  # prime to the size of every set and to the number of kinds in it, so that a part has all kinds


@dataclass(frozen=True)
class Round:
    """What a round consists of.

    Parameters
    ----------
    sets : mapping of str to int
        Number of cases by set.
    seed : int
    out : Path
        Folder of all results; what is there is kept.
    workers : int
    limit : float
        Time limit of a diagnosis [s].
    options : tuple of str
        Further options of ``torquerig diagnose``.
    label : str
        Folder of the results within ``out``; several versions share the recordings.
    """

    sets: dict[str, int]
    seed: int
    out: Path
    workers: int = 1
    limit: float = 600.0
    options: tuple[str, ...] = ()
    label: str = ""

    @property
    def results(self) -> Path:
        """Folder of diagnoses and page."""
        return self.out / self.label

    @property
    def cases(self) -> str:
        """Command that makes the cases, without folders of this machine."""
        words = [f"--set {name}:{count}" for name, count in self.sets.items()]
        return " ".join(["python -m proof fleet", f"--seed {self.seed}", *words])

    @property
    def command(self) -> str:
        """Command that repeats the round, without folders of this machine."""
        label = [f"--label {self.label}"] if self.label else []
        return " ".join([self.cases, *label, *(f"--option={one}" for one in self.options)])

    def jobs(self) -> list[MakeJob]:
        """Return one job for every case, the sets in turn, so that what is done early is a sample of all."""
        ranked = [
            (rank / count, MakeJob(name, self.seed, number, self.out))
            for name, count in self.sets.items()
            for rank, number in enumerate(numbers(name, count))
        ]
        return [job for _, job in sorted(ranked, key=lambda one: one[0])]


def numbers(set_name: str, count: int) -> list[int]:
    """Return the cases of a part of a set, a stratified sample: kinds follow one another in turn within a set.

    INVARIANCE takes whole rigs, because every change is compared with the rig as it is.

    Raises
    ------
    ProofError
        For more cases than the set has.
    """
    size = SETS[set_name].size
    if count > size:
        raise ProofError(f"{set_name} has {size} cases, not {count}; give a smaller number")
    stride = 1 if set_name == "INVARIANCE" else STRIDE
    return [stride * i % size for i in range(count)]


def quick_sizes() -> dict[str, int]:
    """Return a tenth of every set, at least one rig of INVARIANCE with all its changes."""
    sizes = {name: max(one.size // QUICK, 1) for name, one in SETS.items()}
    return sizes | {"INVARIANCE": len(CHANGES)}


def make(plan: Round, *, stage: Stage) -> str:
    """Record what is missing, seal the answers, and return their SHA-256.

    Raises
    ------
    ProofError
        If the folder's answers were sealed with other contents.
    """
    missing = [job for job in plan.jobs() if not is_made(job)]
    run_jobs(made, missing, workers=plan.workers, progress=stage("recording"))
    answers = answers_of(plan)
    digest = hashlib.sha256(json.dumps(answers, sort_keys=True).encode()).hexdigest()
    path = plan.out / SEAL
    kept = dict(line.split() for line in path.read_text(encoding="ascii").splitlines()) if path.is_file() else {}
    key = hashlib.sha256(plan.cases.encode()).hexdigest()[:12]
    if kept.get(key, digest) != digest:
        raise ProofError(f"{path}: the answers changed after they were sealed; choose another --out")
    if key not in kept:
        with path.open("a", encoding="ascii") as stream:
            stream.write(f"{key} {digest}\n")
    return digest


def diagnose_all(plan: Round, *, stage: Stage) -> None:
    """Diagnose what no earlier call has diagnosed."""
    jobs = [
        DiagnoseJob(name, plan.out, answer["without"], plan.limit, plan.options, plan.label)
        for name, answer in answers_of(plan).items()
    ]
    missing = [job for job in jobs if not is_diagnosed(job)]
    run_jobs(diagnosed, missing, workers=plan.workers, progress=stage("diagnosing"))


def verdicts_of(plan: Round) -> list[Verdict]:
    """Return the verdict of every case of a round, those without a diagnosis with their reason."""
    return [_verdict(plan.results, name, answer) for name, answer in answers_of(plan).items()]


def answers_of(plan: Round) -> dict[str, Any]:
    """Return the answers of the round's cases by their names."""
    names = [job.marker.read_text(encoding="utf-8").strip() for job in plan.jobs()]
    return {name: json.loads((plan.out / ANSWERS / f"{name}.json").read_text(encoding="utf-8")) for name in names}


def written(plan: Round, seal: str) -> tuple[list[Verdict], Written]:
    """Judge a round and write its page."""
    verdicts = verdicts_of(plan)
    plan.results.mkdir(parents=True, exist_ok=True)
    return verdicts, write_page(plan.results, verdicts, command=plan.command, seal=seal)


def selected(chosen: Sequence[str], *, quick: bool) -> dict[str, int]:
    """Return the number of cases by set, from texts such as ``FLEET`` or ``FLEET:20``.

    Raises
    ------
    ProofError
        For an unknown set, or a number that is none.
    """
    sizes = quick_sizes() if quick else {name: one.size for name, one in SETS.items()}
    if not chosen:
        return sizes
    answer = {}
    for text in chosen:
        name, _, count = text.partition(":")
        if name not in SETS:
            raise ProofError(f"--set {text}: {name!r} is no set; use one of {', '.join(SETS)}")
        if count and not (count.isdigit() and int(count) > 0):
            raise ProofError(f"--set {text}: {count!r} is no number of cases; write for example {name}:20")
        answer[name] = int(count) if count else sizes[name]
        numbers(name, answer[name])
    return answer


def _verdict(results: Path, name: str, answer: dict[str, Any]) -> Verdict:
    said, refusal = results / DIAGNOSES / f"{name}.json", results / REFUSED / f"{name}.txt"
    why_not = refusal.read_text(encoding="utf-8") if refusal.is_file() else "not diagnosed yet"
    return judged(name, answer, read_claim(said) if said.is_file() else None, why_not="" if said.is_file() else why_not)
