"""The reference report's riddle: what was said of 280 Hz in each of the twelve rigs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from proof.page.cells import said
from proof.prove.scored import OURS, ScoredSet
from proof.rig_program.plan import PlanKind
from proof.scoring.trial import Trial
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter

RIVALS = {"gear_mesh": "planetary mesh 21/84", "pwm_aliasing": "comb of fixed frequency",
          "torsional_mode": "resonance at 280 Hz"}  # fmt: skip


def riddle(sets: Sequence[ScoredSet], wanders: Mapping[str, bool]) -> Chapter:
    """Return one row per rig: what made its 280 Hz, whether its speed wanders, at how many speeds, what was said.

    Parameters
    ----------
    sets : sequence of ScoredSet
    wanders : mapping of str to bool
        By the trial's name.
    """
    trials = [(one, trial) for one in sets for trial in one.trials[OURS]]
    trials.sort(key=lambda pair: (pair[1].effects[0].mechanism, pair[1].plan, wanders.get(pair[1].name, False)))
    rows = tuple(_row(trial, one.said.get(trial.name, {}), wanders.get(trial.name)) for one, trial in trials)
    table = Table(
        caption="280 Hz and its harmonics at 1000 rpm behind 5:1",
        head=("what it was", "speed", "runs at", "said", "worth", "which run would tell"), rows=rows,
        note="Without wander and at one speed, 84 times the output's speed is 280 Hz exactly: then no recording can "
        "tell an order from a fixed frequency, and the right answer is the class and the run that would.",
    )  # fmt: skip
    return Chapter(anchor="riddle", title="The riddle of 280 Hz", tables=(table,))


def _row(trial: Trial, text: Mapping[str, Any], wanders: bool | None) -> tuple[Cell, ...]:
    name = trial.effects[0].mechanism
    runs = [finding.get("next_experiment") for finding in text.get("findings", [])] + [text.get("next_experiment")]
    speeds = "one speed" if trial.plan == PlanKind.ONE_SPEED.value else "two speeds"
    wander = "?" if wanders is None else "wanders" if wanders else "exact"
    return (*words(RIVALS.get(name, name), wander, speeds, said(trial), trial.outcome.value),
            Cell(text=next((run for run in runs if run), "-"), word="remark"))  # fmt: skip
