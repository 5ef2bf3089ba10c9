"""A published decision computed again."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.decide.lints.audit import audit
from torquerig.decide.lints.finding import Finding
from torquerig.study.reference_decision.answer import Answer, answer
from torquerig.study.reference_decision.cell_comparison import ComparedTable, compared_table
from torquerig.study.reference_decision.computed import computed_table
from torquerig.study.reference_decision.known_figures import Known
from torquerig.study.reference_decision.plan import Plan
from torquerig.study.results import StudyRuns
from torquerig.study.run_study import Progress, run_study
from torquerig.study.scoring import Decided, decide


@dataclass(frozen=True, kw_only=True)
class ReferenceDecision:
    """Comparison of every table, the study behind it, and the answer.

    Parameters
    ----------
    findings : tuple of Finding
        Errors of the published tables; those between tables last.
    """

    plan: Plan
    runs: StudyRuns
    decided: Decided
    tables: tuple[ComparedTable, ...]
    findings: tuple[Finding, ...]
    answer: Answer


def reference_decision(
    plan: Plan, *, progress: Progress | None = None, workers: int | None = None
) -> ReferenceDecision:
    """Simulate the drives of the plan's tables, compute the tables, and return the decision."""
    runs = run_study(plan.study, progress=progress, workers=workers)
    known, decided = Known(runs), decide(runs)
    tables = tuple(
        compared_table(computed_table(plan, name, known), plan.book, agree_within=plan.agree_within)
        for name in plan.tables
    )
    return ReferenceDecision(
        plan=plan, runs=runs, decided=decided, tables=tables, findings=audit(plan.book),
        answer=answer(plan, tables, decided),
    )  # fmt: skip
