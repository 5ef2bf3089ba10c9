"""A decision made again as chapters of tables and sentences: the same for page and Markdown."""

from __future__ import annotations

from collections import Counter

from torquerig.decide.lints.finding import Finding
from torquerig.decide.matrix_io.matrix_table import Method
from torquerig.decide.ranks import shown_rank
from torquerig.reporting.layout import Cell, Table, number, span, words
from torquerig.reporting.matrix.chapters import Chapter
from torquerig.reporting.reference_report.decision_trace import trace_chapter
from torquerig.reporting.study.answers import limits
from torquerig.reporting.study.tables import ranking_table
from torquerig.study.reference_decision.cell_comparison import ComparedCell, ComparedTable
from torquerig.study.reference_decision.decision import ReferenceDecision
from torquerig.study.reference_decision.reasons import Cause

COLOURS = {
    Cause.AGREES: "#d5ecd4", Cause.VALUE: "#f6cfca", Cause.READING: "#f9dcb0", Cause.BASELINE: "#d6e4f5",
    Cause.POLARITY: "#e7dcf3", Cause.MISSING: "#fdf0c4",
}  # fmt: skip
"""Background colour of a cell by the cause of its difference."""
RANKED = 10


def chapters(decision: ReferenceDecision) -> tuple[Chapter, ...]:
    """Return all chapters in the order in which they are read."""
    return (
        _answer(decision),
        _overview(decision),
        *(_table(decision, one) for one in decision.tables),
        _between(decision),
        _simulated(decision),
        trace_chapter(decision),
    )


def _answer(decision: ReferenceDecision) -> Chapter:
    lines = decision.answer.sentences()
    missing = tuple(f"Most useful missing value for a new motor: {one}." for one in decision.answer.missing)
    return Chapter(anchor="answer", title="The answer", lines=(*lines, *missing))


def _overview(decision: ReferenceDecision) -> Chapter:
    causes = [cause for cause in Cause if cause is not Cause.AGREES]
    rows = []
    for one in decision.tables:
        found = Counter(cell.reason.cause for cell in one.cells)
        rows.append((*words(one.table.sheet.name), number(str(len(one.cells))), number(str(found[Cause.AGREES])),
                     *(number(str(found[cause])) for cause in causes), number(str(len(one.findings)))))  # fmt: skip
    table = Table(
        caption="Number of cells that agree, and causes of the differences",
        head=("table", "cells", "agree", *(str(cause) for cause in causes), "errors in the table"), rows=tuple(rows),
        note="value: catalog or simulation give another value. interpretation: the printed mark is right for another "
        "meaning of the criterion. baseline: the baseline has the property too, or another gearbox. direction: the row "
        "agrees with the opposite direction. missing value: not decidable yet.",
    )  # fmt: skip
    return Chapter(anchor="overview", title="Published and computed", tables=(table,))


def _table(decision: ReferenceDecision, one: ComparedTable) -> Chapter:
    sheet = one.table.sheet
    reasons = tuple(
        (*words(cell.row), Cell(text=cell.alternative, word="name"), Cell(text=cell.published, word="mark"),
         Cell(text=cell.computed, word="mark"), Cell(text=str(cell.reason.cause), word="name"),
         Cell(text=cell.reason.sentence, word="remark"))
        for cell in one.differing
    )  # fmt: skip
    why = Table(
        caption=f"Reasons why {len(reasons)} of {len(one.cells)} cells differ",
        head=("criterion", "motor", "printed", "computed", "cause", "reason"), rows=reasons,
    )  # fmt: skip
    return Chapter(
        anchor=sheet.name.replace(" ", "-").replace(",", ""),
        title=f"{sheet.name}: {sheet.title}",
        lines=tuple(_finding(finding) for finding in one.findings),
        tables=(_printed_and_computed(decision, one), *((why,) if reasons else ()), *_rated(decision, one)),
    )


def _printed_and_computed(decision: ReferenceDecision, one: ComparedTable) -> Table:
    """Return the table, printed and computed mark in each cell; motors are rows in an elimination, else columns."""
    sheet = one.table.sheet
    names, rows = sheet.alternatives, [row.criterion for row in sheet.rows]
    cells = {(cell.row, cell.alternative): cell for cell in one.cells}
    totals = {label: dict(zip(names, texts, strict=True)) for label, texts in one.totals.items()}
    note = "A cell shows the printed mark, then the computed one where it differs. Gearboxes: " + "; ".join(
        f"{name} on {_gearbox(decision, one, name)}" for name in (*_baseline(one), *names)
    )
    if sheet.method is Method.ELIMINATION:
        body = tuple(
            (
                *words(name),
                *(_mark(cells[row, name]) for row in rows),
                *words(*(totals[label][name] for label in totals)),
            )
            for name in names
        )
        return Table(
            caption=f"{sheet.name}, printed and computed", head=("motor", *rows, *totals), rows=body, note=sheet.note
        )
    head = tuple(_named(decision, name) for name in names)
    purposes = one.table.planned.rows
    body = tuple(
        (*words(row), *words(purposes[row].purpose), *(_mark(cells[row, name]) for name in names)) for row in rows
    )
    below = tuple(
        (*words(label, ""), *(Cell(text=texts[name], word="mark") for name in names)) for label, texts in totals.items()
    )
    return Table(caption=f"{sheet.name}, printed and computed", head=("criterion", "computed as", *head),
                 rows=(*body, *below), note=f"{note}. {sheet.note}".strip())  # fmt: skip


def _rated(decision: ReferenceDecision, one: ComparedTable) -> tuple[Table, ...]:
    """Return the whole computed rating: added motors, and the weight that is missing in print."""
    result = one.rated
    if result is None:
        return ()
    best, worst = (ends.tolist() for ends in result.rank_range)
    rows = [(*words("weight"), *(number(f"{weight:g}") for weight in result.weights), *words("", "", ""))]
    for place, name in enumerate(result.alternatives):
        points = zip(result.low[place].tolist(), result.high[place].tolist(), strict=True)
        rows.append((*words(f"{_named(decision, name)} on {_gearbox(decision, one, name)}"),
                     *(number(span(low, high, 2)) for low, high in points),
                     number(f"{result.share[place]:.3f}"),
                     number(span(float(result.total_low[place] / result.ideal),
                                 float(result.total_high[place] / result.ideal), 2)),
                     number(shown_rank(best[place], worst[place]))))  # fmt: skip
    return (
        Table(
            caption=f"{one.table.sheet.name} computed, with the weight that is missing to a sum of 1 on the stated "
            "goal, and with further motors",
            head=("motor", *result.criteria, "T/T_max", "range", "rank"), rows=tuple(rows),
        ),
    )  # fmt: skip


def _between(decision: ReferenceDecision) -> Chapter:
    within = {finding for one in decision.tables for finding in one.findings}
    rest = [finding for finding in decision.findings if finding not in within]
    catalog, names = decision.plan.study.catalog, {}
    for one in decision.tables:
        for name in one.table.sheet.alternatives:
            alias = catalog.resolved(name)
            if alias is not None:
                names[name] = (catalog.motor(name).stands_for, alias.reason)
    rows = tuple(words(name, real, why) for name, (real, why) in names.items())
    table = Table(caption="Printed names and the motors of the catalog", head=("printed", "motor", "reason"),
                  rows=rows)  # fmt: skip
    return Chapter(anchor="between", title="Errors between the tables", lines=tuple(map(_finding, rest)),
                   tables=(table,) if rows else ())  # fmt: skip


def _simulated(decision: ReferenceDecision) -> Chapter:
    table = ranking_table(decision.decided, winner=decision.answer.overall.winners[0] if decision.answer.overall.winners
                          else "", most=RANKED)  # fmt: skip
    return Chapter(anchor="simulated", title="Simulation and its limits", lines=limits(decision.runs),
                   tables=(table,))  # fmt: skip


def _mark(cell: ComparedCell) -> Cell:
    text = (
        cell.computed if cell.reason.cause is Cause.AGREES and cell.published in _ALIKE.get(cell.computed, "") else None
    )
    shown = cell.published if cell.reason.cause is Cause.AGREES else f"{cell.published} → {cell.computed}"
    title = cell.reason.sentence or f"agrees: {cell.figure.shown()} [{cell.figure.source}]"
    return Cell(
        text=text or shown, style=f"background:{COLOURS[cell.reason.cause]};color:#000", word="mark", title=title
    )


_ALIKE = {"S": "0S"}


def _named(decision: ReferenceDecision, name: str) -> str:
    """Return a printed name, followed by the catalog's where it differs."""
    real = decision.plan.study.catalog.motor(name).stands_for
    return f"{name} ({real})" if real else name


def _gearbox(decision: ReferenceDecision, one: ComparedTable, name: str) -> str:
    if name == one.table.sheet.baseline:
        return decision.plan.study.present_gearbox
    return one.table.planned.gearbox_of(name)


def _baseline(one: ComparedTable) -> tuple[str, ...]:
    return (one.table.sheet.baseline,) if one.table.sheet.baseline else ()


def _finding(finding: Finding) -> str:
    what, why, remedy = (text.rstrip(".") for text in (finding.what, finding.why, finding.remedy))
    return f"{finding.lint}: {what}. Why: {why}. Remedy: {remedy}."
