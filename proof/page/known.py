"""Recordings with known answers that are not blind: practice rigs."""

from __future__ import annotations

from proof.page.cells import had, said
from proof.prove.scored import OURS, ScoredSet
from proof.scoring.outcome import Outcome
from proof.scoring.parameters import errors_of
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter

PERCENT = 100.0


def practice(one: ScoredSet) -> Chapter:
    """Return what was said of each practice rig, with the errors of its parameters."""
    trials = one.trials[OURS]
    right = sum(trial.outcome is Outcome.EXACT for trial in trials)
    rows = []
    for trial in trials:
        errors = [error for match in trial.matches for error in errors_of(match)]
        told = ", ".join(f"{error.name} {PERCENT * error.error:.1f} %" for error in errors) or "-"
        answer = had(trial).replace(" (0.50)", "")
        rows.append((*words(trial.name, answer, said(trial), trial.outcome.value), Cell(text=told, word="remark")))
    table = Table(caption="Practice recordings", head=("", "left out", "said", "worth", "errors of its parameters"),
                  rows=tuple(rows))  # fmt: skip
    return Chapter(anchor="practice", title="Practice recordings", tables=(table,),
                   lines=(f"{right} of {len(trials)} exactly right.",))  # fmt: skip
