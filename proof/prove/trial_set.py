"""The rigs of one seed: drawn, sealed and recorded; finished ones of an earlier call are kept."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.errors import ProofError
from proof.riddle import draw_riddle
from proof.rig_program.draw import Case, answer_of, record_case
from proof.sealed import SEAL, seal, seal_of
from proof.trials import draw_trials

RECORDINGS, DIAGNOSES, BASELINE_VERDICTS = "recordings", "diagnoses", "baselines"
ORACLE, COSTS, REFUSED = "oracle", "costs", "refused"


@dataclass(frozen=True, kw_only=True)
class TrialSet:
    """Trials of one seed in one folder; ``name`` appears on the page."""

    name: str
    seed: int
    folder: Path
    cases: tuple[Case, ...]

    @property
    def answers(self) -> dict[str, Any]:
        """The true answer of each case."""
        return {case.name: answer_of(case) for case in self.cases}


def blind_set(seed: int, cases: int, out: Path, *, duration: float) -> TrialSet:
    """Return the trials of a seed, with drawn laws for each rig."""
    drawn = tuple(draw_trials(seed, cases, duration=duration))
    return TrialSet(name=f"seed {seed}", seed=seed, folder=out / f"seed-{seed}", cases=drawn)


def same_laws_set(seed: int, cases: int, out: Path, *, duration: float) -> TrialSet:
    """Return the same rigs with friction, contact, load shape and integrator of the simulator."""
    drawn = tuple(draw_trials(seed, cases, same_laws=True, duration=duration))
    return TrialSet(name=f"seed {seed}, same laws", seed=seed, folder=out / f"seed-{seed}-same-laws", cases=drawn)


def riddle_set(seed: int, out: Path, *, duration: float) -> TrialSet:
    """Return the twelve rigs with a 280 Hz line."""
    drawn = tuple(draw_riddle(seed, duration=duration))
    return TrialSet(name=f"seed {seed}, riddle", seed=seed, folder=out / f"riddle-{seed}", cases=drawn)


def sealed_digest(trials: TrialSet) -> str:
    """Seal the answers, or check the folder's seal, and return the seal.

    Raises
    ------
    ProofError
        If the folder holds other trials, or something else.
    """
    answers, path = trials.answers, trials.folder / SEAL
    if not path.is_file():
        if trials.folder.exists() and any(trials.folder.iterdir()):
            raise ProofError(f"{trials.folder}: the folder is not empty and has no seal; choose another --out")
        return seal(answers, trials.folder)
    there = path.read_text(encoding="ascii").strip()
    if there != seal_of(answers):
        raise ProofError(
            f"{trials.folder}: its trials do not match this seed, number and rig program (sealed {there[:12]}...); "
            "choose another --out, or use the options of these trials"
        )
    return there


def is_recorded(case: Case, trials: TrialSet) -> bool:
    """Return whether every run of a case was written; a sidecar is written after its table."""
    folder = trials.folder / RECORDINGS / case.name
    return all((folder / f"run{i}.yaml").is_file() for i in range(1, len(case.plan) + 1))


def recorded(job: tuple[Case, Path]) -> str:
    """Record one case into a folder of trials, and return its name."""
    case, folder = job
    record_case(case, folder / RECORDINGS)
    return case.name
