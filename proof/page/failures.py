"""Every wrong case with its diagnosis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from proof.page.cells import diagnosis_text, true_effects_text
from proof.scoring.outcome import Outcome
from proof.scoring.trial import Trial
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter

WORST_FIRST = (
    Outcome.FALSE_NAME, Outcome.NO_ANSWER, Outcome.MISSED, Outcome.UNEXPLAINED, Outcome.PARTIAL,
)  # fmt: skip


def failures(trials: Sequence[Trial], refusals: Mapping[str, str]) -> Chapter:
    """Return the cases that were neither exactly right nor right within the class, worst outcome first."""
    wrong = [trial for trial in trials if trial.outcome in WORST_FIRST]
    wrong.sort(key=lambda trial: WORST_FIRST.index(trial.outcome))
    rows = tuple(
        (*words(trial.name, trial.outcome.value, true_effects_text(trial)),
         Cell(text=refusals.get(trial.name, diagnosis_text(trial)), word="remark"), Cell(text=trial.plan))
        for trial in wrong
    )  # fmt: skip
    if not rows:
        return Chapter(anchor="failures", title="Failures", lines=("None.",))
    table = Table(
        caption=f"{len(wrong)} of {len(trials)} cases",
        head=("case", "outcome", "true effects", "diagnosis", "runs"), rows=rows,
        note="In brackets: the size of a true effect, from 0 (just visible) to 1 (far larger than in handbooks), and "
        "the confidence of a finding.",
    )  # fmt: skip
    return Chapter(anchor="failures", title="Failures", tables=(table,))
