"""The formulas that lead from the entries of a matrix workbook to its points."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from torquerig.decide.criterion import YES_NO, Criterion
from torquerig.decide.matrix_io import excel_layout as layout
from torquerig.reporting.workbook.entry_sheets import criterion_heads, fact_heads, source_rows
from torquerig.reporting.workbook.kesselring_sheet import Links

if TYPE_CHECKING:
    from torquerig.decide.matrix_analysis import MatrixAnalysis

HINT = (
    "Change weights and value functions on the sheet Criteria, facts on the sheet Facts; points, totals and ranks "
    "are recalculated. Run torquerig matrix on this file to update the elimination."
)


def links_of(worked: MatrixAnalysis) -> Links:
    """Return the formulas of the sheet Kesselring for a case."""
    case, result = worked.case, worked.overall
    heads, facts, sources = criterion_heads(case), fact_heads(case), source_rows(case)
    rows = {one.name: place for place, one in enumerate(case.matrix.criteria, start=1)}
    known = {one.name: one for one in case.matrix.criteria}
    floor, ceiling = (_at(layout.SETTINGS, layout.SETTING_KEYS.index(key) + 1, 1) for key in ("scale min", "scale max"))

    def weight(column: int) -> str:
        return f"={_at(layout.CRITERIA, rows[result.criteria[column]], heads.index('weight'))}"

    def points(row: int, column: int, block: int) -> str:
        pair = result.alternatives[row], result.criteria[column]
        line = case.matrix.alternatives.index(pair[0]) + 1
        held = [_at(layout.FACTS, line, facts.index(head)) if head in facts else ""
                for head in (pair[1], layout.LOW.format(pair[1]), layout.HIGH.format(pair[1]))]  # fmt: skip
        hand = sources.index(pair) + 1 if pair in sources else 0
        cell = case.matrix.cell(*pair)
        if cell.points_by_hand is not None:
            return f"={_at(layout.SOURCES, hand, layout.SOURCE_HEADS.index('by hand points'))}"
        if cell.by_hand is not None:
            held = [_at(layout.SOURCES, hand, layout.SOURCE_HEADS.index("by hand value")), "", ""]
        return (
            f"={_points(held, known[pair[1]], _knots(heads, rows[pair[1]], known[pair[1]]), (floor, ceiling), block)}"
        )

    return Links(weight=weight, points=points, ideal=f"={ceiling}", hint=HINT)


Knots = Sequence[tuple[str, str]]


def _points(held: Sequence[str], criterion: Criterion, knots: Knots, scale: tuple[str, str], block: int) -> str:
    """Return the points of a fact: block 0 the middle, 1 the fewest, 2 the most that it allows."""
    value, low, high = held
    if criterion.unit == YES_NO:
        is_known, value = f'OR({value}="yes",{value}="no")', f'IF({value}="yes",1,0)'
    else:
        is_known = f"ISNUMBER({value})"
    given = _value_function(value, knots)
    ends = [f"IF({is_known},{given},{end})" for end in scale]
    if low:
        at = [_value_function(end, knots) for end in (low, high)]
        inside = [[f"IF(AND({low}<{x},{x}<{high}),{p},{at[0]})" for x, p in knots] for _ in (0, 1)]
        spans = [f"{name}({','.join([*at, *extra])})" for name, extra in zip(("MIN", "MAX"), inside, strict=True)]
        ends = [f"IF(ISNUMBER({low}),{span},{end})" for span, end in zip(spans, ends, strict=True)]
    if block:
        return ends[block - 1]
    return f"IF({is_known},{given},({ends[0]}+{ends[1]})/2)"


def _value_function(value: str, knots: Knots) -> str:
    """Return straight lines between the knots and level ends, as nested IFs."""
    text = knots[-1][1]
    for (left, low), (right, high) in reversed(list(pairwise(knots))):
        text = f"IF({value}<={right},{low}+({value}-{left})*({high}-{low})/({right}-{left}),{text})"
    return f"IF({value}<={knots[0][0]},{knots[0][1]},{text})"


def _knots(heads: Sequence[str], row: int, criterion: Criterion) -> Knots:
    count = len(criterion.value.knots) if criterion.value else 0
    return [
        (
            _at(layout.CRITERIA, row, heads.index(layout.KNOT.format(place))),
            _at(layout.CRITERIA, row, heads.index(layout.POINTS.format(place))),
        )
        for place in range(1, count + 1)
    ]


def _at(sheet: str, row: int, column: int) -> str:
    from xlsxwriter.utility import xl_rowcol_to_cell

    return f"{sheet}!{xl_rowcol_to_cell(row, column, row_abs=True, col_abs=True)}"
