"""Results recalculated from the cells of a printed table, and the columns of an elimination that decide."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.criterion import Kind
from torquerig.decide.eliminate import Mark, SelectionChart, chart_from_marks
from torquerig.decide.kesselring import KesselringResult, kesselring_from_points
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, Entry, MatrixTable, Row, canonical
from torquerig.decide.matrix_io.written_values import LEVELS
from torquerig.decide.pugh import PughResult, pugh_from_levels


def recomputed_chart(table: MatrixTable, *, without: tuple[str, ...] = ()) -> SelectionChart:
    """Apply the strict rule to printed marks, without the criteria ``without``, which are wishes."""
    tested = [place for place, row in enumerate(table.rows) if row.criterion not in without]
    marks = {name: [Mark(str(table.column(name)[place])) for place in tested] for name in table.alternatives}
    return chart_from_marks(marks, criteria=[table.rows[place].criterion for place in tested], source=table.name)


def undeciding_rows(table: MatrixTable) -> tuple[Row, ...]:
    """Return the rows of a printed elimination that never decided: an alternative passed with ``-``, or none got one.

    A row that all meet is a met requirement and not returned.
    """
    undeciding = []
    for row in table.rows:
        failed = [entry == "-" for entry in row.entries]
        ignored = any(fail and passed for fail, passed in zip(failed, table.passed, strict=True))
        if ignored or (not any(failed) and set(row.entries) != {"+"}):
            undeciding.append(row)
    return tuple(undeciding)


def recomputed_pugh(table: MatrixTable, *, correct_baseline: bool = False) -> PughResult:
    """Add up printed signs; with ``correct_baseline``, ``+`` becomes ``S`` where the baseline has the property too."""
    rows = [_at_best_same(row) if correct_baseline and row.baseline_has else row.entries for row in table.rows]
    open_ends = (-2, 2) if any(entry in ("++", "--") for entries in rows for entry in entries) else (-1, 1)
    levels = {
        name: [_levels(entries[place], open_ends) for entries in rows] for place, name in enumerate(table.alternatives)
    }
    return pugh_from_levels(levels, baseline=table.baseline, criteria=[row.criterion for row in table.rows])


def weighted_nets(table: MatrixTable) -> NDArray[np.float64]:
    """Return the weighted sums of printed signs, shape (3, alternatives): every ? worst, left out, and best.

    The sum of weight times sign, ``++`` as 2, with the weights as printed. Source: Ulrich and Eppinger, Product Design
    and Development, concept scoring.
    """
    result, weights = recomputed_pugh(table), np.array(table.weights)
    known = np.where(result.low == result.high, result.low, 0)
    return np.stack([ends[1:] @ weights for ends in (result.low, known, result.high)])


def recomputed_kesselring(table: MatrixTable) -> KesselringResult:
    """Return the weighted sums of printed points; ``?`` becomes the whole scale."""
    points = {name: points_of(table, name) for name in table.alternatives}
    weights = {row.criterion: row.weight or 0.0 for row in table.rows}
    return kesselring_from_points(points, weights=weights, profile=table.profile)


def technical_shares(table: MatrixTable) -> tuple[float, ...]:
    """Return T/T_max of each alternative without the economic rows; the middle of the scale where unknown."""
    technical = [place for place, row in enumerate(table.rows) if row.kind is Kind.TECHNICAL and row.weight]
    result = recomputed_kesselring(table)
    weights = result.weights[technical]
    shares = result.middle[:, technical] @ weights / (table.profile.p_max * np.sum(weights))
    return tuple(shares.tolist())


def points_of(table: MatrixTable, alternative: str) -> tuple[float | None, ...]:
    """Return the printed points of one alternative, None where unknown."""
    return tuple(entry if isinstance(entry, float) else None for entry in table.column(alternative))


def _levels(entry: Entry, open_ends: tuple[int, int]) -> tuple[int, int]:
    if entry == UNKNOWN:
        return open_ends
    level = LEVELS[str(canonical(entry))]
    return level, level


def _at_best_same(row: Row) -> tuple[Entry, ...]:
    return tuple("S" if entry in ("+", "++") else entry for entry in row.entries)
