"""The results of a case in the form of printed tables, so that the same lints check them."""

from __future__ import annotations

from torquerig.decide.case import MatrixCase
from torquerig.decide.eliminate import Decision, Mark, SelectionChart, eliminate
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.matrix_table import Entry, MatrixTable, Method, Row, TableSet
from torquerig.decide.pugh import PughResult, pugh


def survivors(matrix: DecisionMatrix) -> DecisionMatrix:
    """Return the matrix without the eliminated alternatives; all of it where the requirements eliminate every one."""
    eliminated = set(eliminate(matrix).with_decision(Decision.ELIMINATE))
    kept = [name for name in matrix.alternatives if name not in eliminated]
    return matrix.only(alternatives=kept) if kept else matrix


def computed_tables(case: MatrixCase) -> TableSet:
    """Return elimination, Pugh and Kesselring of a case, with its goal and aliases."""
    matrix = case.matrix
    tables = (
        _chart_table(eliminate(matrix), case),
        _pugh_table(pugh(matrix, case.baseline), case),
        _points_table(kesselring(survivors(matrix), profile=case.profile), case),
    )
    return TableSet(
        tables=tuple(table for table in tables if table.rows and table.alternatives),
        goal=case.goal,
        goal_words=case.goal_words,
        aliases=case.aliases,
    )


def _chart_table(chart: SelectionChart, case: MatrixCase) -> MatrixTable:
    names = tuple(row.alternative for row in chart.rows)
    passed = {Decision.PURSUE: True, Decision.ELIMINATE: False}
    return MatrixTable(
        name="Elimination",
        method=Method.ELIMINATION,
        alternatives=names,
        rows=tuple(
            _row(case, name, tuple(str(row.marks.get(name, "")) for row in chart.rows))
            for name in chart.criteria
            if any(row.marks.get(name) is not Mark.MEETS for row in chart.rows)
        ),
        passed=tuple(passed.get(row.decision) for row in chart.rows),
    )


def _pugh_table(result: PughResult, case: MatrixCase) -> MatrixTable:
    names = tuple(name for name in result.alternatives if name != result.baseline)
    signs = {name: result.signs(name) for name in names}
    return MatrixTable(
        name="Pugh",
        method=Method.PUGH,
        alternatives=names,
        baseline=result.baseline,
        rows=tuple(
            _row(case, criterion, tuple(str(signs[name][place]) for name in names))
            for place, criterion in enumerate(result.criteria)
        ),
    )


def _points_table(result: KesselringResult, case: MatrixCase) -> MatrixTable:
    """Return the points as a table: the middle of an interval, and ``?`` where the whole scale is open."""
    open_cells = result.high - result.low >= result.profile.p_max - result.profile.p_min
    return MatrixTable(
        name="Kesselring",
        method=Method.KESSELRING,
        alternatives=result.alternatives,
        profile=result.profile,
        rows=tuple(
            _row(
                case,
                name,
                tuple(
                    "?" if unknown else points
                    for points, unknown in zip(
                        result.middle[:, column].tolist(), open_cells[:, column].tolist(), strict=True
                    )
                ),
                weight=float(result.weights[column]),
            )
            for column, name in enumerate(result.criteria)
        ),
    )


def _row(case: MatrixCase, name: str, entries: tuple[Entry, ...], *, weight: float | None = None) -> Row:
    criterion = next(one for one in case.matrix.criteria if one.name == name)
    return Row(
        criterion=name, entries=entries, weight=weight, kind=criterion.kind, better=criterion.better,
        purpose=criterion.purpose, place=case.places.get(name, ""),
    )  # fmt: skip
