"""The uncertainty budget of a study, kept with the drive that it is for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from torquerig.cases.kept_values import kept_or_made

if TYPE_CHECKING:
    from torquerig.study.answer.uncertainty_budget import UncertaintyBudget
    from torquerig.study.results import DriveResult, StudyRuns

CLASSES = frozenset({
    "torquerig.study.answer.uncertainty_budget:UncertaintyBudget", "torquerig.study.answer.uncertainty_item:Item",
})  # fmt: skip
"""What a budget is made of."""


def kept_budget(drive: DriveResult, chain: str, runs: StudyRuns) -> UncertaintyBudget:
    """Return :func:`torquerig.study.answer.uncertainty_budget.uncertainty_budget`, kept or calculated now."""

    def calculate() -> UncertaintyBudget:
        from torquerig.study.answer.uncertainty_budget import uncertainty_budget

        return uncertainty_budget(drive, chain, runs)

    content = (runs.row_keys.get(drive.candidate.name, ""), chain, runs.mean_load)
    return kept_or_made(runs.kept, "budget", content, calculate, classes=CLASSES)
