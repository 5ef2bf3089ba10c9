"""A case with its sealed answer, its diagnosis and its outcome."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from proof.scoring.claims import Claim, read_claim
from proof.scoring.improvement import Improvement, improvement_of
from proof.scoring.outcome import Match, Outcome, TrueEffect, judge, match_findings


@dataclass(frozen=True)
class Trial:
    """One case: true verdict ``due``, true effects, diagnosis and outcome."""

    name: str
    due: str
    effects: tuple[TrueEffect, ...]
    plan: str
    wrong_parameters: bool
    claim: Claim | None
    outcome: Outcome
    matches: tuple[Match, ...]
    improvement: Improvement | None

    @property
    def kind(self) -> str:
        """Kind of the case."""
        if self.due == "unexplained":
            return "effects outside the library"
        if self.effects:
            return "one effect" if len(self.effects) == 1 else "two effects"
        return "wrong parameters only" if self.wrong_parameters else "clean"


def trial_of(name: str, answer: dict[str, Any], claim: Claim | None, *, oracle: Claim | None = None) -> Trial:
    """Return one case with its outcome."""
    effects = tuple(
        TrueEffect(
            row["mechanism"], row["in_library"], float(row["size"]), tuple(row["also_right"]), dict(row["parameters"])
        )
        for row in answer["effects"]
    )
    return Trial(
        name=name,
        due=answer["verdict"],
        effects=effects,
        plan=answer["plan"],
        wrong_parameters=answer["wrong_parameters"],
        claim=claim,
        outcome=judge(answer["verdict"], effects, claim),
        matches=tuple(match_findings(effects, claim.findings)) if claim else (),
        improvement=improvement_of(claim, oracle) if claim else None,
    )


def read_trials(answers: dict[str, Any], folder: Path) -> list[Trial]:
    """Return every sealed case with ``diagnoses/NAME.json``, and ``oracle/NAME.json`` if there is one."""
    trials = []
    for name, answer in sorted(answers.items()):
        found, oracle = folder / "diagnoses" / f"{name}.json", folder / "oracle" / f"{name}.json"
        claim = read_claim(found) if found.is_file() else None
        trials.append(trial_of(name, answer, claim, oracle=read_claim(oracle) if oracle.is_file() else None))
    return trials
