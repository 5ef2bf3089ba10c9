"""A published decision made again, all of it."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.study.reference_decision.answer import Answer, answer
from torquerig.study.reference_decision.beside import TableBeside, table_beside
from torquerig.study.reference_decision.computed import computed_table
from torquerig.study.reference_decision.figures import Known
from torquerig.study.reference_decision.plan import Plan
from torquerig.study.results import StudyRuns
from torquerig.study.run_study import Progress, run_study
from torquerig.study.scoring import Decided, decide


@dataclass(frozen=True, kw_only=True)
class RedoneDecision:
    """Every table beside its published one, the study behind it, and the answer.

    Parameters
    ----------
    findings : tuple of Finding
        What is wrong with the published tables, those between the tables last.
    """

    plan: Plan
    runs: StudyRuns
    decided: Decided
    tables: tuple[TableBeside, ...]
    findings: tuple[Finding, ...]
    answer: Answer


def redone(plan: Plan, *, progress: Progress | None = None, workers: int | None = None) -> RedoneDecision:
    """Simulate what the plan's tables need, compute them, and answer their question; the same plan, the same result."""
    runs = run_study(plan.study, progress=progress, workers=workers)
    known, decided = Known(runs), decide(runs)
    tables = tuple(
        table_beside(computed_table(plan, name, known), plan.book, agree_within=plan.agree_within)
        for name in plan.tables
    )
    return RedoneDecision(
        plan=plan, runs=runs, decided=decided, tables=tables, findings=audit(plan.book),
        answer=answer(plan, tables, decided),
    )  # fmt: skip
