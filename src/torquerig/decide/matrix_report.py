"""The whole text of ``torquerig matrix``: published tables audited, or one's own matrix run through the engines."""

from __future__ import annotations

from pathlib import Path

from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Decision, Mark, SelectionChart, eliminate
from torquerig.decide.flips import flip_weights
from torquerig.decide.kesselring import KesselringResult, kesselring
from torquerig.decide.lints.audit import audit
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.matrix_file import MatrixCase, matrix_from
from torquerig.decide.pugh import PughResult, pugh, sweep_datums
from torquerig.decide.robustness import best_shares
from torquerig.decide.seed_tables import tables_from
from torquerig.decide.sheet import Book, Method, Row, Sheet
from torquerig.decide.telling import (
    heading,
    tell_chart,
    tell_findings,
    tell_kesselring,
    tell_matrix,
    tell_pugh,
    tell_ratings,
    tell_robustness,
    tell_sweep,
)
from torquerig.decide.telling_printed import tell_sheet
from torquerig.document import read_document


def matrix_report(path: Path) -> str:
    """Return the text for a file of published tables (it has ``tables:``) or for one's own matrix.

    Raises
    ------
    InputError
        One sentence with file, line, key and remedy.
    """
    document = read_document(path)
    if isinstance(document.data, dict) and "tables" in document.data:
        return tell_book(tables_from(document))
    return tell_case(matrix_from(document))


def tell_book(book: Book) -> str:
    """Return all tables as printed and recomputed, then what is wrong with them."""
    findings = audit(book)
    title = heading(f"What the tables get wrong: {len(findings)} findings")
    return "\n\n".join([*(tell_sheet(sheet) for sheet in book.sheets), title, tell_findings(findings)]) + "\n"


def tell_case(case: MatrixCase) -> str:
    """Return one's own matrix with the three methods, how sure the winner is, and the lints."""
    matrix = case.matrix
    rated = survivors(matrix)
    result = kesselring(rated, profile=case.profile)
    flips = flip_weights(result) if len(rated.alternatives) > 1 else ()
    shares = best_shares(rated, profile=case.profile, draws=case.draws, seed=case.seed)
    out = ", ".join(name for name in matrix.alternatives if name not in rated.alternatives)
    left_out = f"\nleft out, as a demand eliminates it: {out}" if out else ""
    findings = audit(computed_book(case))
    parts = [
        (f"{matrix.name}: what is known", tell_matrix(matrix)),
        ("Elimination: who meets the demands", tell_chart(eliminate(matrix))),
        (f"Pugh against {case.datum}", tell_pugh(pugh(matrix, case.datum))),
        ("Pugh with every alternative as datum", tell_sweep(sweep_datums(matrix))),
        (f"Kesselring, points {case.profile.name}", tell_kesselring(result) + left_out),
        *_apart(rated, case),
        ("How sure the winner is", tell_robustness(shares, flips)),
        (f"Lints: {len(findings)} findings", tell_findings(findings)),
    ]
    return "\n\n".join(f"{heading(title)}\n{text}" for title, text in parts) + "\n"


def survivors(matrix: DecisionMatrix) -> DecisionMatrix:
    """Return the matrix without the eliminated alternatives; the whole of it where the demands leave nobody."""
    out = set(eliminate(matrix).with_decision(Decision.ELIMINATE))
    left = [name for name in matrix.alternatives if name not in out]
    return matrix.only(alternatives=left) if left else matrix


def computed_book(case: MatrixCase) -> Book:
    """Return the three computed tables of a case as sheets, so that the same lints run over them."""
    matrix = case.matrix
    kinds = {criterion.name: criterion.kind for criterion in matrix.criteria}
    sheets = (
        _chart_sheet(eliminate(matrix)),
        _pugh_sheet(pugh(matrix, case.datum), kinds),
        _points_sheet(kesselring(survivors(matrix), profile=case.profile), kinds),
    )
    return Book(
        sheets=tuple(sheet for sheet in sheets if sheet.rows and sheet.alternatives),
        goal=case.goal,
        goal_words=case.goal_words,
    )


def _apart(matrix: DecisionMatrix, case: MatrixCase) -> list[tuple[str, str]]:
    """Return the technical and the economic rating on their own, where both are weighed."""
    kinds = {criterion.kind for criterion in matrix.criteria if criterion.weight > 0}
    if len(kinds) < 2:
        return []
    x, y = (kesselring(matrix.only(kind=kind), profile=case.profile) for kind in Kind)
    return [("Technical and economic rating apart", tell_ratings(x, y))]


def _chart_sheet(chart: SelectionChart) -> Sheet:
    names = tuple(row.alternative for row in chart.rows)
    passed = {Decision.PURSUE: True, Decision.ELIMINATE: False}
    return Sheet(
        name="Elimination",
        method=Method.ELIMINATION,
        alternatives=names,
        rows=tuple(
            Row(criterion=name, entries=tuple(str(row.marks.get(name, "")) for row in chart.rows))
            for name in chart.criteria
            if any(row.marks.get(name) is not Mark.MEETS for row in chart.rows)
        ),
        passed=tuple(passed.get(row.decision) for row in chart.rows),
    )


def _pugh_sheet(result: PughResult, kinds: dict[str, Kind]) -> Sheet:
    names = tuple(name for name in result.alternatives if name != result.datum)
    signs = {name: result.signs(name) for name in names}
    return Sheet(
        name="Pugh",
        method=Method.PUGH,
        alternatives=names,
        datum=result.datum,
        rows=tuple(
            Row(criterion=criterion, entries=tuple(str(signs[name][place]) for name in names), kind=kinds[criterion])
            for place, criterion in enumerate(result.criteria)
        ),
    )


def _points_sheet(result: KesselringResult, kinds: dict[str, Kind]) -> Sheet:
    """Return the points as a sheet: the middle of an interval, and ``?`` where the whole scale is open."""
    open_cells = result.high - result.low >= result.profile.p_max - result.profile.p_min
    return Sheet(
        name="Kesselring",
        method=Method.KESSELRING,
        alternatives=result.alternatives,
        profile=result.profile,
        rows=tuple(
            Row(
                criterion=name,
                weight=float(result.weights[column]),
                kind=kinds[name],
                entries=tuple(
                    "?" if unknown else points
                    for points, unknown in zip(
                        result.middle[:, column].tolist(), open_cells[:, column].tolist(), strict=True
                    )
                ),
            )
            for column, name in enumerate(result.criteria)
        ),
    )
