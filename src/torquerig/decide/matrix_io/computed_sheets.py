"""The three computed tables of a case as sheets, so that the lints of printed tables run over them."""

from __future__ import annotations

from torquerig.decide.case import MatrixCase
from torquerig.decide.eliminate import Decision, Mark, SelectionChart, eliminate
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_io.sheet import Book, Entry, Method, Row, Sheet
from torquerig.decide.pugh import PughResult, pugh


def survivors(matrix: DecisionMatrix) -> DecisionMatrix:
    """Return the matrix without the eliminated alternatives; the whole of it where the demands leave nobody."""
    out = set(eliminate(matrix).with_decision(Decision.ELIMINATE))
    left = [name for name in matrix.alternatives if name not in out]
    return matrix.only(alternatives=left) if left else matrix


def computed_book(case: MatrixCase) -> Book:
    """Return elimination, Pugh and Kesselring of a case, with its goal and aliases."""
    matrix = case.matrix
    sheets = (
        _chart_sheet(eliminate(matrix), case),
        _pugh_sheet(pugh(matrix, case.datum), case),
        _points_sheet(kesselring(survivors(matrix), profile=case.profile), case),
    )
    return Book(
        sheets=tuple(sheet for sheet in sheets if sheet.rows and sheet.alternatives),
        goal=case.goal,
        goal_words=case.goal_words,
        aliases=case.aliases,
    )


def _chart_sheet(chart: SelectionChart, case: MatrixCase) -> Sheet:
    names = tuple(row.alternative for row in chart.rows)
    passed = {Decision.PURSUE: True, Decision.ELIMINATE: False}
    return Sheet(
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


def _pugh_sheet(result: PughResult, case: MatrixCase) -> Sheet:
    names = tuple(name for name in result.alternatives if name != result.datum)
    signs = {name: result.signs(name) for name in names}
    return Sheet(
        name="Pugh",
        method=Method.PUGH,
        alternatives=names,
        datum=result.datum,
        rows=tuple(
            _row(case, criterion, tuple(str(signs[name][place]) for name in names))
            for place, criterion in enumerate(result.criteria)
        ),
    )


def _points_sheet(result: KesselringResult, case: MatrixCase) -> Sheet:
    """Return the points as a sheet: the middle of an interval, and ``?`` where the whole scale is open."""
    open_cells = result.high - result.low >= result.profile.p_max - result.profile.p_min
    return Sheet(
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
