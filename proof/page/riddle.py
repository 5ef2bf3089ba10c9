"""Diagnoses of the twelve rigs with a 280 Hz line."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from proof.page.cells import diagnosis_text
from proof.prove.scored import OURS, ScoredSet
from proof.rig_program.plan import PlanKind
from proof.scoring.trial import Trial
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter

CAUSES = {"gear_mesh": "planetary mesh 21/84", "pwm_aliasing": "comb of fixed frequency",
          "torsional_mode": "resonance at 280 Hz"}  # fmt: skip


def riddle(sets: Sequence[ScoredSet], wanders: Mapping[str, bool]) -> Chapter:
    """Return one row per rig: cause of its 280 Hz line, speed variation, number of speeds, diagnosis.

    Parameters
    ----------
    sets : sequence of ScoredSet
    wanders : mapping of str to bool
        Whether the speed varies, by the trial's name.
    """
    trials = [(one, trial) for one in sets for trial in one.trials[OURS]]
    trials.sort(key=lambda pair: (pair[1].effects[0].mechanism, pair[1].plan, wanders.get(pair[1].name, False)))
    rows = tuple(_row(trial, one.said.get(trial.name, {}), wanders.get(trial.name)) for one, trial in trials)
    table = Table(
        caption="280 Hz and its harmonics at 1000 rpm behind 5:1",
        head=("true cause", "speed", "runs at", "diagnosis", "outcome", "next run"), rows=rows,
        note="At one exact speed, 84 times the output speed is 280 Hz. No recording then distinguishes an order from a "
        "fixed frequency. The right answer is the class with the next run that distinguishes them.",
    )  # fmt: skip
    return Chapter(anchor="riddle", title="The 280 Hz line: mesh, comb or resonance", tables=(table,))


def _row(trial: Trial, data: Mapping[str, Any], wanders: bool | None) -> tuple[Cell, ...]:
    name = trial.effects[0].mechanism
    runs = [finding.get("next_experiment") for finding in data.get("findings", [])] + [data.get("next_experiment")]
    speeds = "one speed" if trial.plan == PlanKind.ONE_SPEED.value else "two speeds"
    wander = "?" if wanders is None else "varies" if wanders else "exact"
    return (*words(CAUSES.get(name, name), wander, speeds, diagnosis_text(trial), trial.outcome.value),
            Cell(text=next((run for run in runs if run), "-"), word="remark"))  # fmt: skip
