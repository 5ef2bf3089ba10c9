"""Calculation of each cell of a published decision, with its catalog values."""

from __future__ import annotations

from torquerig.decide.cell import Origin
from torquerig.metrics.figure import Figure
from torquerig.reporting.layout import Cell, Table, words
from torquerig.reporting.matrix.chapters import Chapter
from torquerig.study.origins import FACT_TEXTS, metric_text, origin_of
from torquerig.study.reference_decision.cell_comparison import ComparedCell, ComparedTable
from torquerig.study.reference_decision.decision import ReferenceDecision
from torquerig.study.settings import SIMULATED


def trace_chapter(decision: ReferenceDecision) -> Chapter:
    """Return the calculation of the cells, one table per published table, and the catalog values of the drives."""
    tables = tuple(_cells(decision, one) for one in decision.tables)
    return Chapter(anchor="way", title="Calculation of every cell",
                   tables=(*tables, _simulated(decision)))  # fmt: skip


def _cells(decision: ReferenceDecision, one: ComparedTable) -> Table:
    rows = tuple(
        (*words(cell.row, cell.alternative), Cell(text=_catalog(decision, one, cell), word="remark narrow"),
         Cell(text=_calculation(decision, one, cell), word="remark narrow"), *words(_value(cell.figure)),
         Cell(text=cell.computed, word="mark"))
        for cell in one.cells
    )  # fmt: skip
    return Table(
        caption=f"{one.table.sheet.name}: calculation of the computed marks",
        head=("criterion", "motor", "catalog values", "calculation", "value", "computed"), rows=rows,
    )  # fmt: skip


def _catalog(decision: ReferenceDecision, one: ComparedTable, cell: ComparedCell) -> str:
    origins = [origin_of(*known) for known in cell.figure.rests_on]
    if one.table.planned.rows[cell.row].metric in SIMULATED:
        box = one.table.planned.gearbox_of(cell.alternative)
        made = next((row for row in decision.runs.drives if _is(decision, row.candidate.motor, cell.alternative)
                     and row.candidate.gearbox == box), None)  # fmt: skip
        return f"{len(origins)} values of {made.candidate.name}, listed below" if made else "not simulated"
    return "; ".join(_origin_text(origin) for origin in origins) or "none"


def _calculation(decision: ReferenceDecision, one: ComparedTable, cell: ComparedCell) -> str:
    metric, settings = one.table.planned.rows[cell.row].metric, decision.plan.study.settings
    return FACT_TEXTS.get(metric) or metric_text(metric, cell.figure, chain=settings.present.filter, settings=settings)


def _value(figure: Figure) -> str:
    unit = "" if figure.unit == "1" or figure.unknown else f" {figure.unit}"
    sure = figure.low == figure.high and not figure.unknown
    missing = f"; missing: {figure.missing}" if figure.missing and not sure else ""
    return f"{figure.shown()}{unit}{missing}"


def _simulated(decision: ReferenceDecision) -> Table:
    rows = tuple(
        words(drive.candidate.name, origin.name, origin.shown, origin.evidence, origin.source)
        for drive in decision.runs.drives
        for origin in (origin_of(one.name, one.known) for one in drive.taken.values())
    )
    return Table(caption="The catalog values of each simulated drive", rows=rows,
                 head=("drive", "catalog value", "known", "evidence", "source"))  # fmt: skip


def _origin_text(origin: Origin) -> str:
    evidence = f" [{origin.evidence}]" if origin.evidence else ""
    return f"{origin.name}: {origin.shown}{evidence}{f', from {origin.source}' if origin.source else ''}"


def _is(decision: ReferenceDecision, motor: str, published: str) -> bool:
    entry = decision.plan.study.catalog.motor(published)
    return motor == (entry.stands_for or entry.name)
