"""Whether the criteria of a sheet are rows or columns: decided by its content, refused where that decides nothing."""

from __future__ import annotations

from torquerig.decide.matrix_io.written_sheet.block import Block, largest_block
from torquerig.decide.matrix_io.written_sheet.grid import Grid, is_value
from torquerig.decide.matrix_io.written_sheet.lines import Lines, column_names, lines_of, repeated_names
from torquerig.decide.matrix_io.written_sheet.weights import are_shares, are_surely_weights
from torquerig.decide.matrix_io.written_sheet.words import (
    Word,
    is_datum,
    is_numbered_alternative,
    total_of,
    unit_in_name,
    word_of,
)
from torquerig.decide.matrix_io.written_values import pugh_mark
from torquerig.errors import InputError


def oriented_lines(grid: Grid) -> Lines | None:
    """Return the lines of the matrix of a sheet, turned so that criteria are rows; None where there is no matrix.

    Raises
    ------
    InputError
        Where nothing, or contradictory content, shows which names are the alternatives; both readings and the remedy
        are named. As :func:`~torquerig.decide.matrix_io.written_sheet.lines.lines_of` too.
    """
    block = largest_block(grid)
    if block is None:
        return None
    turned = Block(header=block.labels, labels=block.header, values=block.values)
    down, across = evidence(grid, block), evidence(grid.turned(), turned)
    if not (down and across):
        down, across = _with_corner(grid, block, down, across)
    if not (down or across):
        down, across = _only_same(grid, block), _only_same(grid.turned(), turned)
    if down and not across:
        return lines_of(grid, block)
    if across and not down:
        return lines_of(grid.turned(), turned)
    corner = grid.name(block.header, block.labels)
    above, left = _some(grid, block, is_header=True), _some(grid, block, is_header=False)
    remedy = f"write 'criterion' in {corner} if {left} are the criteria, or 'alternative' if they are the alternatives"
    if not down:
        raise InputError(
            f"{grid.origin}: the alternatives may be {above} (row {block.header + 1}) or {left} (down from {corner}); "
            f"nothing in the sheet decides it; {remedy}"
        )
    raise InputError(
        f"{grid.origin}: {left} may be the criteria ({'; '.join(down)}) or the alternatives ({'; '.join(across)}); "
        "remove or rename what is wrong"
    )


def evidence(grid: Grid, block: Block) -> list[str]:
    """Return what shows that the criteria of a block are rows of the grid, each with its cells; empty if nothing."""
    names = column_names(grid, block)
    below = [row for row in grid.rows if row > block.header and (row, block.labels) in grid.cells]
    labels = {row: grid.text(row, block.labels) for row in below}
    repeated = repeated_names(grid.turned(), Block(header=block.labels, labels=block.header, values=block.values))
    named = [row for row in grid.rows if row != block.header and (row, block.labels) in grid.cells]
    labels |= {row: grid.text(row, block.labels) for row in named}
    named = [row for row in named if labels[row] not in repeated]
    totals = [row for row in named if total_of(labels[row]) and _values(grid, row, names) > 1]
    criteria = [row for row in below if row not in totals and _values(grid, row, names) > 0]
    column = grid.line_word(is_row=False)
    found = [
        f"the {column} {names[one]!r} in {grid.name(block.header, one)}"
        for one in names
        if names[one] and _marks_rows(grid, names, one, criteria)
    ]
    found += [f"{labels[row]!r} in {grid.name(row, block.labels)} is a result" for row in totals]
    for (row, other), value in grid.cells.items():
        title = word_of(str(value)) if isinstance(value, str) else None
        over, beside = row < block.header and other > block.labels, row > block.header and other < block.labels
        if (over and title is Word.ALTERNATIVE) or (beside and title is Word.CRITERION):
            found.append(f"{value!r} in {grid.name(row, other)}")
    with_unit = [row for row in criteria if unit_in_name(labels[row]) and not is_datum(labels[row])]
    if 2 * len(with_unit) > len(criteria):
        found.append(f"names with units in {grid.span([(row, block.labels) for row in with_unit])}")
    numbered = [one for one in names if is_numbered_alternative(names[one])]
    if len(numbered) > 1:
        found.append(f"names of alternatives in {grid.span([(block.header, one) for one in numbered])}")
    return found


def has_decision_word(grid: Grid) -> bool:
    """Return whether a sheet names criteria, alternatives, weights, a datum or an ideal, as only a matrix does."""
    words = (Word.CRITERION, Word.ALTERNATIVE, Word.WEIGHT, Word.IDEAL)
    texts = [value for value in grid.cells.values() if isinstance(value, str)]
    return any(word_of(text) in words or is_datum(text) for text in texts)


def _with_corner(grid: Grid, block: Block, down: list[str], across: list[str]) -> tuple[list[str], list[str]]:
    """Return the evidence with the word in the corner, which names the lines below it and yields to weights and datum.

    A word in the corner may also be the title of the names at its right, so that it alone does not contradict.
    """
    word = word_of(grid.text(block.header, block.labels))
    said = [f"{grid.text(block.header, block.labels)!r} in {grid.name(block.header, block.labels)}"]
    strong = any(one.startswith("the ") for one in (*down, *across))
    if word is Word.CRITERION and not (across and strong):
        return [*down, *said], across
    if word is Word.ALTERNATIVE and not (down and strong):
        return down, [*across, *said]
    return down, across


def _marks_rows(grid: Grid, names: dict[int, str], column: int, criteria: list[int]) -> bool:
    """Return whether a column can only stand next to criteria: weights, datum, ideal, units."""
    word = word_of(names[column])
    filled = any(is_value(grid.cells.get((row, column))) for row in criteria)
    if word is Word.MASS_OR_WEIGHT:
        others = [one for one in names if one != column]
        return bool(criteria) and are_surely_weights(grid, criteria, column, others)
    if word is Word.LETTER:
        return bool(criteria) and are_shares(grid, criteria, column)
    spelled = word_of("".join(grid.text(row, column) for row in criteria)) is Word.DATUM
    return (word in (Word.WEIGHT, Word.IDEAL) and filled) or word is Word.UNIT or is_datum(names[column]) or spelled


def _only_same(grid: Grid, block: Block) -> list[str]:
    """Return the column that alone holds S only; a row of the same kind would decide the contrary."""
    names = column_names(grid, block)
    rows = [row for row in grid.rows if row > block.header and _values(grid, row, names) > 0]
    written = {(row, one): pugh_mark(grid.cells.get((row, one))) for row in rows for one in names}
    columns = [one for one in names if names[one] and {written[row, one] for row in rows} == {"S"}]
    if len(columns) != 1 or len(rows) < 2:
        return []
    return [f"S only in {grid.span([(row, columns[0]) for row in rows])}"]


def _values(grid: Grid, row: int, names: dict[int, str]) -> int:
    return sum(is_value(grid.cells.get((row, column))) for column in names)


def _some(grid: Grid, block: Block, *, is_header: bool) -> str:
    if is_header:
        names = [text for one in grid.columns if one > block.labels and (text := grid.text(block.header, one))]
    else:
        names = [text for one in grid.rows if one > block.header and (text := grid.text(one, block.labels))]
    return ", ".join(repr(name[:30]) for name in names[:3]) + (", ..." if len(names) > 3 else "")
