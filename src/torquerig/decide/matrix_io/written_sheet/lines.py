"""Which rows are criteria and totals, and which columns are alternatives, weights and the datum."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

from torquerig.decide.matrix_io.written_sheet.block import Block
from torquerig.decide.matrix_io.written_sheet.grid import Grid, is_value
from torquerig.decide.matrix_io.written_sheet.weights import are_shares, is_product
from torquerig.decide.matrix_io.written_sheet.words import Total, Word, is_datum, names_product, total_of, word_of
from torquerig.errors import InputError


@dataclass(frozen=True, kw_only=True)
class Lines:
    """The lines of a block whose criteria are rows of the grid.

    Parameters
    ----------
    names : mapping of column to str
        The names of the alternatives, the datum and the ideal.
    criteria : mapping of row to str
    totals : mapping of row to Total
    rated : tuple of int
        The columns of the alternatives, without datum, ideal and products.
    weights, datum, ideal : int or None
        Their columns.
    products : mapping of column to column
        From the column of the points to that of weight times points.
    headings, unused : tuple of int
        Rows with a name only; columns of text or line numbers, which nothing reads.
    """

    grid: Grid
    block: Block
    names: dict[int, str]
    criteria: dict[int, str]
    totals: dict[int, Total]
    rated: tuple[int, ...]
    weights: int | None = None
    datum: int | None = None
    ideal: int | None = None
    products: dict[int, int] = field(default_factory=dict)
    headings: tuple[int, ...] = ()
    unused: tuple[int, ...] = ()


def column_names(grid: Grid, block: Block) -> dict[int, str]:
    """Return the name of each column; repeated ones (points, weighted) get the name merged over them."""
    own = {column: grid.text(block.header, column) for column in grid.columns if column != block.labels}
    repeated = repeated_names(grid, block)
    above = [row for row in grid.rows if row < block.header]
    if not repeated or not above:
        return own
    over, names = "", {}
    for column, name in own.items():
        over = grid.text(above[-1], column) or over
        names[column] = over if over and name in repeated else name or grid.text(above[-1], column)
    return names


def repeated_names(grid: Grid, block: Block) -> set[str]:
    """Return the column names that occur more than once, as the second line of a head with two lines has."""
    given = [grid.text(block.header, column) for column in grid.columns if (block.header, column) in grid.cells]
    return {name for name in given if given.count(name) > 1}


def lines_of(grid: Grid, block: Block) -> Lines:
    """Return the lines of a block if its criteria are rows.

    Raises
    ------
    InputError
        With the cell: values without a name, a row that is filled in part, criteria below totals, a text among values.
    """
    names = column_names(grid, block)
    below = [row for row in grid.rows if row > block.header]
    filled = {column: [row for row in below if is_value(grid.cells.get((row, column)))] for column in names}
    texts = {column: sum((row, column) in grid.cells for row in below) - len(filled[column]) for column in names}
    weights = _weights(grid, block, names, filled)
    second = _products(grid, names, [c for c in names if filled[c] and c != weights], tuple(below), weights)
    single = {word: [c for c in names if filled[c] and word_of(names[c]) is word] for word in Word}
    single = {word: [c for c in columns if c not in second.values()] for word, columns in single.items()}
    datum = _one(grid, block, [c for c in names if is_datum(names[c])] or _spelled(grid, names, below), "datum")
    ideal = _one(grid, block, single[Word.IDEAL], "ideal")
    apart = (weights, datum, ideal, None if ideal is None else second.get(ideal))
    kept = [c for c in names if filled[c] and len(filled[c]) >= texts[c] and c not in apart]
    beside = {row for c in kept if names[c] for row in filled[c]}
    kept = [c for c in kept if c not in single[Word.NUMBER] and (names[c] or beside & {*filled[c]})]
    criteria, totals, headings = _rows(grid, block, kept, weights)
    products = _products(grid, names, kept, tuple(criteria), weights)
    rated = tuple(c for c in kept if c not in products.values())
    products |= {ideal: second[ideal]} if ideal in second else {}
    _refuse_unnamed(grid, names, rated, tuple(criteria))
    known = {*apart, *kept}
    return Lines(
        grid=grid, block=block, names={c: names[c] for c in names if c in known}, criteria=criteria, totals=totals,
        rated=rated, weights=weights, datum=datum, ideal=ideal, products=products, headings=tuple(headings),
        unused=tuple(c for c in names if c not in known and any((row, c) in grid.cells for row in below)),
    )  # fmt: skip


def _weights(grid: Grid, block: Block, names: dict[int, str], filled: dict[int, list[int]]) -> int | None:
    """Return the column of the weights: named so, or named ambiguously, or by a letter with values of weights."""
    named = {word: [c for c in names if filled[c] and word_of(names[c]) is word] for word in Word}
    letters = [c for c in named[Word.LETTER] if are_shares(grid, filled[c], c)]
    for column, name in names.items():
        text = next((row for row in grid.rows if row > block.header and (row, column) in grid.cells), None)
        if word_of(name) in (Word.WEIGHT, Word.MASS_OR_WEIGHT) and text is not None and not filled[column]:
            written = grid.text(text, column)[:40]
            raise InputError(f"{grid.place(text, column)}: the weight {written!r} is no number; write 20 %, 0.2 or 20")
    return _one(grid, block, named[Word.WEIGHT] or named[Word.MASS_OR_WEIGHT][:1] or letters, "weights")


def _one(grid: Grid, block: Block, columns: list[int], what: str) -> int | None:
    if len(columns) > 1:
        first, second = (grid.name(block.header, column) for column in columns[:2])
        raise InputError(
            f"{grid.origin}: {first} and {second} both name the {what}; keep one of them, or rename the other"
        )
    return columns[0] if columns else None


def _spelled(grid: Grid, names: dict[int, str], below: list[int]) -> list[int]:
    """Return the columns that have no marks but the word datum written down them, in one cell or letter by letter."""
    joined = {c: "".join(grid.text(row, c) for row in below if (row, c) in grid.cells) for c in names if names[c]}
    return [c for c, text in joined.items() if word_of(text) is Word.DATUM]


def _rows(
    grid: Grid, block: Block, kept: list[int], weights: int | None
) -> tuple[dict[int, str], dict[int, Total], list[int]]:
    criteria: dict[int, str] = {}
    totals: dict[int, Total] = {}
    headings: list[int] = []
    for row in grid.rows:
        label = grid.cells.get((row, block.labels))
        name = grid.text(row, block.labels) if isinstance(label, str) else ""
        held = [column for column in kept if is_value(grid.cells.get((row, column)))]
        total = total_of(name) if name else None
        has_weight = weights is not None and is_value(grid.cells.get((row, weights)))
        if row <= block.header and total is None:
            continue
        if total is not None and (held or has_weight):
            totals[row] = total
        elif held and not name:
            raise InputError(
                f"{grid.place(row, block.labels)}: the values of {grid.span([(row, c) for c in held])} have no name; "
                "write the criterion, or sum or rank, or clear them"
            )
        elif held or has_weight:
            _check_criterion(grid, block, (row, held), kept, totals)
            criteria[row] = name
        else:
            headings.append(row)
    return criteria, totals, headings


def _check_criterion(
    grid: Grid, block: Block, line: tuple[int, list[int]], kept: list[int], totals: dict[int, Total]
) -> None:
    row, held = line
    name = grid.text(row, block.labels)
    above = [one for one in totals if one > block.header]
    if above:
        last = above[-1]
        raise InputError(
            f"{grid.place(row, block.labels)}: {name!r} comes after the {totals[last].value} "
            f"{grid.text(last, block.labels)!r} in {grid.name(last, block.labels)}; move the results after all "
            "criteria, give the result one of the names sum, rank or total, and use one sheet for each matrix"
        )
    if 2 * len(held) < len(kept):
        raise InputError(
            f"{grid.place(row, block.labels)}: {name!r} has {len(held)} of {len(kept)} values; write ? where a value "
            "is unknown, or move the line to another sheet if it is no criterion"
        )
    for column in kept:
        cell = grid.cells.get((row, column))
        if cell is not None and not is_value(cell):
            raise InputError(
                f"{grid.place(row, column)}: {str(cell)[:40]!r} is neither a mark nor points; write + S - or a number, "
                "or ? where it is unknown"
            )


def _refuse_unnamed(grid: Grid, names: dict[int, str], rated: tuple[int, ...], criteria: tuple[int, ...]) -> None:
    seen: dict[str, int] = {}
    rows = criteria or grid.rows
    for column in rated:
        if not names[column]:
            spots = [(row, column) for row in grid.rows if is_value(grid.cells.get((row, column)))]
            raise InputError(
                f"{grid.origin}, {grid.span(spots)}: these values have no name of an alternative; write it in the "
                f"{'row' if not grid.is_turned else 'column'} of the names, or clear them (a "
                "decimal comma in a file with commas between the cells makes one cell two)"
            )
        if names[column] in seen:
            one, other = (grid.span([(row, place) for row in rows]) for place in (column, seen[names[column]]))
            raise InputError(
                f"{grid.origin}: the name {names[column]!r} occurs twice, over {one} and {other}; "
                "give each alternative a different name"
            )
        seen[names[column]] = column


def _products(
    grid: Grid, names: dict[int, str], kept: list[int], criteria: tuple[int, ...], weights: int | None
) -> dict[int, int]:
    """Return the columns that hold weight times the points of the column before, found by the numbers in them."""
    if weights is None:
        return {}
    found: dict[int, int] = {}
    for first, second in pairwise(kept):
        if first in found.values():
            continue
        same_name = names[second] in ("", names[first])
        if not same_name and names[first] not in names[second] and not names_product(names[second]):
            continue
        if is_product(grid, criteria, (first, second, weights), share=0.5 if same_name else 1.0):
            found[first] = second
    return found
