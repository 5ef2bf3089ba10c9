"""Recordings, scenario and answer of one case; what an earlier call finished is kept."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.fleet.answers import answer_of
from proof.fleet.recording import write_recordings
from proof.referee.edits import apply
from proof.referee.invariance import CHANGES
from proof.referee.sets import SETS, TrialCase, drawn
from proof.rig_program.draw import answer_of as wear_answer
from proof.rig_program.draw import record_case
from proof.trials import draw_trial

RECORDINGS, ANSWERS = "recordings", "answers"
WEAR_SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "wear_rig.yaml"
BACKWARDS = "backwards"
"""Name of an empty file next to recordings that are given in reverse order."""


@dataclass(frozen=True)
class MakeJob:
    """One case of a set and the folder of the round."""

    set_name: str
    seed: int
    number: int
    out: Path

    @property
    def marker(self) -> Path:
        """File that says which case was made: its name."""
        return self.out / "made" / f"{self.set_name}-{self.seed}-{self.number:03d}.txt"


def is_made(job: MakeJob) -> bool:
    """Return whether an earlier call made the case."""
    return job.marker.is_file()


def made(job: MakeJob) -> str:
    """Draw and record one case, write its answer, and return its name; the marker is written last."""
    if job.set_name == "WEAR":
        name, answer = _wear(job)
    else:
        case = drawn(job.set_name, job.seed, job.number)
        name, answer = case.name, _fleet(job, case)
    path = job.out / ANSWERS / f"{name}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(answer, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    job.marker.parent.mkdir(parents=True, exist_ok=True)
    job.marker.write_text(name + "\n", encoding="utf-8")
    return name


def _fleet(job: MakeJob, trial: TrialCase) -> dict[str, Any]:
    folder = job.out / RECORDINGS / trial.name
    write_recordings(trial.case.rig, folder)
    facts = []
    if trial.fault is not None:
        apply(trial.fault.edit, folder)
        facts = [trial.fault.as_dict()]
    if trial.change:
        edit = CHANGES[trial.change]()
        apply(edit, folder)
        if edit.backwards:
            (folder / BACKWARDS).touch()
    answer = answer_of(trial.case, set_name=job.set_name, outside=trial.outside, setup=facts)
    return answer | {"without": trial.without, "change": trial.change}


def _wear(job: MakeJob) -> tuple[str, dict[str, Any]]:
    case = draw_trial(job.seed, job.number + 1, SETS["WEAR"].size)
    name = f"wear-{job.seed}-{job.number:03d}"
    folder = job.out / RECORDINGS / name
    record_case(case, folder.parent)
    (folder.parent / case.name).rename(folder)
    (folder / "scenario.yaml").write_text(WEAR_SCENARIO.read_text(encoding="utf-8"), encoding="utf-8")
    answer = wear_answer(case)
    effects = [effect | {"part": "", "places": [], "counts": True, "nats": None} for effect in answer["effects"]]
    rig = {"motor": "bldc", "drive": "one_stage", "load": "particles", "plan": answer["plan"],
           "angle": "encoder" if answer["encoder"] else "none", "sample_rate_Hz": 25000.0}  # fmt: skip
    turns = {"output_shaft": 1.0, "motor_shaft": 5.0}
    return name, answer | {"set": "WEAR", "effects": effects, "setup": [], "rig": rig, "without": "", "change": "",
                           "turns_per_output_turn": turns}  # fmt: skip
