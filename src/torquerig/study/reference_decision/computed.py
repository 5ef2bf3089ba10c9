"""The published tables as matrices of computed cells, one per table, with the published names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from torquerig.decide.criterion import Better, Criterion, Indifference, Kind, Requirement, ValueFunction
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method, Row
from torquerig.metrics.figure import Figure
from torquerig.study.reference_decision.known_figures import Known
from torquerig.study.reference_decision.plan import Plan, PlannedTable, Reading
from torquerig.study.scoring import cell_of

Figures = Mapping[tuple[str, str], Figure]


@dataclass(frozen=True, kw_only=True)
class ComputedTable:
    """A published table, computed.

    Parameters
    ----------
    sheet : MatrixTable
        As published.
    planned : PlannedTable
    matrix : DecisionMatrix
        Under the published names: the baseline first (Pugh), added motors last.
    figures : mapping of (alternative, row) to Figure
    otherwise : DecisionMatrix
        The rows with another possible interpretation, computed so.
    other_figures : mapping
        Of ``otherwise``.
    same_gearbox : DecisionMatrix or None
        With the baseline on the gearbox of the table (Pugh).
    """

    sheet: MatrixTable
    planned: PlannedTable
    matrix: DecisionMatrix
    figures: Figures
    otherwise: DecisionMatrix | None
    other_figures: Figures
    same_gearbox: DecisionMatrix | None = None


def computed_table(plan: Plan, name: str, known: Known) -> ComputedTable:
    """Return one published table with every cell computed."""
    sheet, planned = plan.book.table(name), plan.tables[name]
    boxes = {one: planned.gearbox_of(one) for one in (*sheet.alternatives, *planned.also)}
    if sheet.method is Method.PUGH:
        boxes = {sheet.baseline: plan.study.present_gearbox, **boxes}
    readings: dict[str, Reading] = {**planned.rows, **planned.missing}
    criteria = [criterion_of(one, readings[one], _printed(sheet, one)) for one in readings]
    if planned.missing:
        criteria[-1] = replace(criteria[-1], weight=round(1 - sum(sheet.weights), 9))
    figures = {
        (one, row): known.figure(one, box, readings[row].metric) for one, box in boxes.items() for row in readings
    }
    others = {row: planned.rows[row].otherwise for row in planned.rows}
    second = {row: reading for row, reading in others.items() if reading is not None}
    other_figures = {
        (one, row): known.figure(one, box, second[row].metric) for one, box in boxes.items() for row in second
    }
    matrix = _matrix(name, tuple(boxes), tuple(criteria), figures)
    same = None
    if sheet.method is Method.PUGH:
        moved = {
            (sheet.baseline, row): known.figure(sheet.baseline, planned.gearbox, readings[row].metric)
            for row in readings
        }
        same = _matrix(name, tuple(boxes), tuple(criteria), {**figures, **moved})
    return ComputedTable(
        sheet=sheet,
        planned=planned,
        matrix=matrix,
        figures=figures,
        otherwise=_matrix(
            name, tuple(boxes), tuple(criterion_of(row, one, None) for row, one in second.items()), other_figures
        )
        if second
        else None,
        other_figures=other_figures,
        same_gearbox=same,
    )


def criterion_of(name: str, reading: Reading, printed: Row | None) -> Criterion:
    """Return the criterion of a reading, with the printed weight and kind."""
    limited = reading.min is not None or reading.max is not None
    return Criterion(
        name=name,
        unit=reading.unit,
        better=Better(reading.better),
        band=reading.band,
        requirement=Requirement(low=reading.min, high=reading.max) if limited else None,
        indifference=Indifference(absolute=reading.same_within.absolute, relative=reading.same_within.relative),
        value=ValueFunction(tuple(sorted(reading.points.items()))) if reading.points else None,
        weight=(printed.weight or 0.0) if printed is not None else 0.0,
        kind=printed.kind if printed is not None else Kind.TECHNICAL,
        purpose=reading.purpose,
    )


def _printed(sheet: MatrixTable, name: str) -> Row | None:
    return next((row for row in sheet.rows if row.criterion == name), None)


def _matrix(
    name: str, alternatives: tuple[str, ...], criteria: tuple[Criterion, ...], figures: Figures
) -> DecisionMatrix:
    names = {one.name for one in criteria}
    cells = {key: cell_of(figure) for key, figure in figures.items() if key[1] in names}
    return DecisionMatrix(name=name, alternatives=alternatives, criteria=criteria, cells=cells)
