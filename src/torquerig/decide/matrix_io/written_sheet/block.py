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
    row_places, column_places = ({line: at for at, line in enumerate(lines)} for lines in (rows, columns))
    for (row, column), cell in grid.cells.items():
        place = row_places[row], column_places[column]
        if is_value(cell):
            value[place] = 1
        elif isinstance(cell, str):
            text[place] = 1
    named = text @ (text.T @ value).T
    most = int(named.max(initial=0))
    if most < SMALLEST:
        return None
    turned = grid.turned()
    across, down = [_flaws(grid, row) for row in rows], [_flaws(turned, column) for column in columns]
    pairs = np.argwhere(named == most).tolist()
    up, left = min(
        pairs, key=lambda pair: _order(grid, (rows[pair[0]], columns[pair[1]]), across[pair[0]], down[pair[1]])
    )
    header, labels = rows[up], columns[left]
    held = (text[:, [left]] * value) * text[[up], :]
    is_table = min((held.sum(axis=axis) > 0).sum() for axis in (0, 1)) > 1
    return Block(header=header, labels=labels, values=most, is_table=bool(is_table))


def _flaws(grid: Grid, line: int) -> tuple[int, int]:
    """Return how many names of a row are repeated, and how many are units in brackets."""
    names = [grid.text(line, column) for column in grid.columns if (line, column) in grid.cells]
    return len(names) - len({*names}), sum(name[0] in "[(" and bool(unit_in_name(name)) for name in names)


def _order(grid: Grid, pair: tuple[int, int], across: tuple[int, int], down: tuple[int, int]) -> tuple[int | bool, ...]:
    """Return what speaks against a pair of lines of names, in the order of its weight."""
    corner = word_of(grid.text(*pair)) not in (Word.CRITERION, Word.ALTERNATIVE)
    return corner, across[0] + down[0], across[1] + down[1], *pair
