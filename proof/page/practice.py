"""Practice rigs: recordings with known answers, not blind."""

from __future__ import annotations

from proof.page.cells import diagnosis_text, true_effects_text
from proof.prove.scored import OURS, ScoredSet
from proof.scoring.outcome import Outcome
from proof.scoring.parameters import errors_of
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter

PERCENT = 100.0


def practice(one: ScoredSet) -> Chapter:
    """Return the diagnosis of each practice rig, with the errors of its parameters."""
    trials = one.trials[OURS]
    right = sum(trial.outcome is Outcome.EXACT for trial in trials)
    rows = []
    for trial in trials:
        errors = [error for match in trial.matches for error in errors_of(match)]
        errors_text = ", ".join(f"{error.name} {PERCENT * error.error:.1f} %" for error in errors) or "-"
        answer = true_effects_text(trial).replace(" (0.50)", "")
        rows.append(
            (
                *words(trial.name, answer, diagnosis_text(trial), trial.outcome.value),
                Cell(text=errors_text, word="remark"),
            )
        )
    table = Table(caption="Practice recordings", head=("", "true effects", "diagnosis", "outcome", "parameter errors"),
                  rows=tuple(rows))  # fmt: skip
    return Chapter(anchor="practice", title="Practice recordings", tables=(table,),
                   lines=(f"{right} of {len(trials)} exactly right.",))  # fmt: skip
