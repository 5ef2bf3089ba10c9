"""The three engines run over the cells of a sheet, and which columns of a printed elimination decide at all."""

from __future__ import annotations

import numpy as np

from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Mark, SelectionChart, chart_from_marks
from torquerig.decide.kesselring import KesselringResult, kesselring_from_points
from torquerig.decide.matrix_io.sheet import Entry, Row, Sheet, canonical
from torquerig.decide.pugh import PughResult, Sign, pugh_from_signs


def recomputed_chart(sheet: Sheet, *, without: tuple[str, ...] = ()) -> SelectionChart:
    """Apply the strict rule to printed marks, with the criteria ``without`` set aside as wishes."""
    asked = [place for place, row in enumerate(sheet.rows) if row.criterion not in without]
    marks = {name: [Mark(str(sheet.column(name)[place])) for place in asked] for name in sheet.alternatives}
    return chart_from_marks(marks, criteria=[sheet.rows[place].criterion for place in asked], source=sheet.name)


def undeciding_rows(sheet: Sheet) -> tuple[Row, ...]:
    """Return the rows of a printed elimination that never decided: somebody passed with ``-``, or nobody got one.

    A row that everybody meets is a fulfilled demand and not returned.
    """
    undeciding = []
    for row in sheet.rows:
        failed = [entry == "-" for entry in row.entries]
        ignored = any(fail and passed for fail, passed in zip(failed, sheet.passed, strict=True))
        if ignored or (not any(failed) and set(row.entries) != {"+"}):
            undeciding.append(row)
    return tuple(undeciding)


def recomputed_pugh(sheet: Sheet, *, correct_datum: bool = False) -> PughResult:
    """Add up printed signs; with ``correct_datum``, ``+`` becomes ``S`` where the datum has the property too."""
    rows = [_at_best_same(row) if correct_datum and row.datum_has else row.entries for row in sheet.rows]
    signs = {
        name: [Sign(str(canonical(entries[place]))) for entries in rows]
        for place, name in enumerate(sheet.alternatives)
    }
    return pugh_from_signs(signs, datum=sheet.datum, criteria=[row.criterion for row in sheet.rows])


def recomputed_kesselring(sheet: Sheet) -> KesselringResult:
    """Weigh printed points; ``?`` becomes the whole scale."""
    points = {name: points_of(sheet, name) for name in sheet.alternatives}
    weights = {row.criterion: row.weight or 0.0 for row in sheet.rows}
    return kesselring_from_points(points, weights=weights, profile=sheet.profile)


def technical_shares(sheet: Sheet) -> tuple[float, ...]:
    """Return T/T_max of each alternative without the economic rows; the middle of the scale where unknown."""
    technical = [place for place, row in enumerate(sheet.rows) if row.kind is Kind.TECHNICAL and row.weight]
    result = recomputed_kesselring(sheet)
    weights = result.weights[technical]
    shares = result.middle[:, technical] @ weights / (sheet.profile.p_max * np.sum(weights))
    return tuple(shares.tolist())


def points_of(sheet: Sheet, alternative: str) -> tuple[float | None, ...]:
    """Return the printed points of one alternative, None where unknown."""
    return tuple(entry if isinstance(entry, float) else None for entry in sheet.column(alternative))


def _at_best_same(row: Row) -> tuple[Entry, ...]:
    return tuple("S" if entry == "+" else entry for entry in row.entries)
