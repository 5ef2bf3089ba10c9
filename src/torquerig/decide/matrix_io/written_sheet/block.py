"""The largest block of a sheet in which every value has a name at its row and at its column."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from torquerig.decide.matrix_io.written_sheet.grid import Grid, is_value
from torquerig.decide.matrix_io.written_sheet.words import Word, unit_in_name, word_of

SMALLEST = 2  # values; one criterion with two alternatives is the smallest matrix


@dataclass(frozen=True, kw_only=True)
class Block:
    """A block of values: the row of the column names, the column of the row names, and the count of named values.

    ``is_table`` is False where the values are in one row or in one column only, as in a legend.
    """

    header: int
    labels: int
    values: int
    is_table: bool = True


def largest_block(grid: Grid) -> Block | None:
    """Return the row and column of names that name the most values; None where they name fewer than two.

    With T as 1 for text and V as 1 for values, row h and column l name sum over r, c of T[r,l] V[r,c] T[h,c] values,
    which is one element of the product T (T^T V)^T.
    """
    rows, columns = grid.rows, grid.columns
    text, value = np.zeros((len(rows), len(columns))), np.zeros((len(rows), len(columns)))
    for (row, column), cell in grid.cells.items():
        place = rows.index(row), columns.index(column)
        if is_value(cell):
            value[place] = 1
        elif isinstance(cell, str):
            text[place] = 1
    named = text @ (text.T @ value).T
    most = int(named.max(initial=0))
    if most < SMALLEST:
        return None
    pairs = [(rows[row], columns[column]) for row, column in np.argwhere(named == most).tolist()]
    header, labels = min(pairs, key=lambda pair: _flaws(grid, *pair))
    up, left = rows.index(header), columns.index(labels)
    held = (text[:, [left]] * value) * text[[up], :]
    is_table = min((held.sum(axis=axis) > 0).sum() for axis in (0, 1)) > 1
    return Block(header=header, labels=labels, values=most, is_table=bool(is_table))


def _flaws(grid: Grid, header: int, labels: int) -> tuple[int | bool, ...]:
    """Return what speaks against a pair of lines of names, in the order of its weight."""
    across = [grid.text(header, column) for column in grid.columns if (header, column) in grid.cells]
    down = [grid.text(row, labels) for row in grid.rows if (row, labels) in grid.cells]
    corner = word_of(grid.text(header, labels)) not in (Word.CRITERION, Word.ALTERNATIVE)
    repeated = len(across) - len({*across}) + len(down) - len({*down})
    units = sum(bool(unit_in_name(name)) and name[0] in "[(" for name in (*across, *down))
    return corner, repeated, units, header, labels
