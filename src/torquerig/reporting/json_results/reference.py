"""The results of ``torquerig reference-results`` and ``torquerig reference-decision``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from torquerig.study.reference_decision.decision import ReferenceDecision
from torquerig.study.reference_report.results import ReportResults


@dataclass(frozen=True)
class ReportCell:
    """A cell of the report: published and simulated reduction of the standard deviation."""

    table: str
    row: str
    fitted: bool
    published_percent: float
    simulated_percent: float
    lowest_percent: float
    highest_percent: float
    without_fit_percent: float


@dataclass(frozen=True)
class ReferenceResultsResult:
    """All cells of the report, and sentences on the differences."""

    cells: tuple[ReportCell, ...]
    notes: tuple[str, ...]
    written: tuple[str, ...]


@dataclass(frozen=True)
class DecisionCell:
    """A cell of a published table: printed and computed mark, and the cause of a difference."""

    table: str
    row: str
    alternative: str
    published: str
    computed: str
    cause: str
    reason: str


@dataclass(frozen=True)
class ReferenceDecisionResult:
    """The published decision computed again: every cell, and the answer."""

    seed: int
    published: str
    chosen: str
    keeps_present_motor: bool
    keeps_share: float
    sentences: tuple[str, ...]
    missing_facts: tuple[str, ...]
    cells: tuple[DecisionCell, ...]
    written: tuple[str, ...]


def reference_results_result(
    results: ReportResults, *, notes: Sequence[str], written: Sequence[str]
) -> ReferenceResultsResult:
    """Return the comparison with the results of the report."""
    cells = tuple(
        ReportCell(
            str(one.cell.table), one.cell.shown, one.cell.fitted, one.cell.cut, one.cut, one.lowest, one.highest,
            one.shipped_cut,
        )
        for one in results.cells
    )  # fmt: skip
    return ReferenceResultsResult(cells, tuple(notes), tuple(written))


def reference_decision_result(made: ReferenceDecision, *, written: Sequence[str]) -> ReferenceDecisionResult:
    """Return the published decision and the computed one."""
    cells = tuple(
        DecisionCell(
            one.table.sheet.name, cell.row, cell.alternative, cell.published, cell.computed, str(cell.reason.cause),
            cell.reason.sentence,
        )
        for one in made.tables
        for cell in one.cells
    )  # fmt: skip
    answer = made.answer
    return ReferenceDecisionResult(
        seed=made.runs.study.settings.seed, published=answer.published, chosen=answer.chosen,
        keeps_present_motor=answer.keeps, keeps_share=answer.keeps_share, sentences=tuple(answer.sentences()),
        missing_facts=tuple(answer.missing), cells=cells, written=tuple(written),
    )  # fmt: skip
