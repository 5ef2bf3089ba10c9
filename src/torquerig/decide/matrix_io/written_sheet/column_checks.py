"""Columns that may be something else than they look like: text with ratings in it, and weights under another name."""

from __future__ import annotations

import re

import numpy as np

from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method
from torquerig.decide.matrix_io.written_sheet.lines import Lines
from torquerig.decide.matrix_io.written_sheet.weights import are_shares
from torquerig.decide.matrix_io.written_sheet.words import Total, Word, word_of
from torquerig.decide.matrix_io.written_values import number_of
from torquerig.errors import InputError

_STARTS_AS_RATING = re.compile(r"\s*[+\-\u2212\u2013]?\d")


def refuse_unread_ratings(lines: Lines) -> None:
    """Raise InputError for a column of text between the alternatives, or whose texts start as points do."""
    grid = lines.grid
    for column in lines.unused:
        spots = [(row, column) for row in lines.criteria if (row, column) in grid.cells]
        if not spots or not grid.text(lines.block.header, column) or word_of(grid.text(lines.block.header, column)) in (
            Word.UNIT, Word.NUMBER,
        ):  # fmt: skip
            continue
        rating_like = sum(bool(_STARTS_AS_RATING.match(grid.text(*spot))) for spot in spots)
        if 2 * rating_like > len(spots) or min(lines.rated) < column < max(lines.rated):
            raise InputError(
                f"{grid.place(*spots[0])}: {grid.text(*spots[0])[:40]!r} is neither a mark nor points; write + S - or "
                f"a number, or move the {grid.line_word(is_row=False)} away from the alternatives if it is a remark"
            )


def refuse_hidden_weights(lines: Lines, table: MatrixTable) -> None:
    """Raise InputError where one of the alternatives may be the weights: shares of 1, or the written sums say so."""
    if lines.weights is not None or table.method is not Method.KESSELRING:
        return
    grid, rows = lines.grid, list(lines.criteria)
    sums = [row for row, kind in lines.totals.items() if kind in (Total.SUM, Total.WEIGHTED)]
    points = {column: [number_of(grid.cells.get((row, column))) or 0.0 for row in rows] for column in lines.rated}
    for column in lines.rated:
        shares = are_shares(grid, rows, column) and len(rows) > 1
        if shares or any(_agrees(lines, row, column, points) for row in sums):
            where, other = grid.place(lines.block.header, column), lines.names[column]
            raise InputError(
                f"{where}: {other!r} may be an alternative or the weights of the criteria; rename it to 'weight' if it "
                "holds the weights, or write a line 'weight' with 1 for each criterion if it is an alternative"
            )


def _agrees(lines: Lines, row: int, column: int, points: dict[int, list[float]]) -> bool:
    """Return whether written sums follow with one column as the weights, and do not follow without weights."""
    weights = np.array(points[column])
    others = [one for one in lines.rated if one != column]
    written = [number_of(lines.grid.cells.get((row, one))) for one in others]
    known = [(points[one], value) for one, value in zip(others, written, strict=True) if value is not None]
    if not known or not weights.any() or np.all(weights == 1):
        return False
    plain = all(abs(sum(cells) - value) < 0.005 for cells, value in known)
    return not plain and any(
        all(abs(float(weights @ np.array(cells)) * scale - value) < 0.005 for cells, value in known)
        for scale in (1.0, 0.01, 1.0 / float(weights.sum()))
    )
