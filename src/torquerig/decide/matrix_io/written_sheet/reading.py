"""A decision sheet as people write it, read as one table, with sentences on what was understood."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.matrix_io.matrix_table import UNKNOWN, Entry, MatrixTable, Method, Row, TableSet
from torquerig.decide.matrix_io.written_sheet.block import largest_block
from torquerig.decide.matrix_io.written_sheet.column_checks import refuse_hidden_weights, refuse_unread_ratings
from torquerig.decide.matrix_io.written_sheet.grid import Grid, Spot, text_grid, workbook_grids
from torquerig.decide.matrix_io.written_sheet.lines import Lines
from torquerig.decide.matrix_io.written_sheet.orientation import has_decision_word, oriented_lines
from torquerig.decide.matrix_io.written_sheet.ratings import marks_of, method_of, points_of_cells, profile_of
from torquerig.decide.matrix_io.written_sheet.totals import refuse_unnamed_result, refuse_weighted_total
from torquerig.decide.matrix_io.written_sheet.understood import understood, used_cells
from torquerig.decide.matrix_io.written_sheet.weights import weights_of
from torquerig.decide.matrix_io.written_values import number_of, weight_of
from torquerig.errors import InputError

NO_DATUM = "datum (no column)"


@dataclass(frozen=True, kw_only=True)
class SheetReading:
    """The tables of a file, and what was understood of each of its sheets, in sentences."""

    tables: TableSet
    understood: tuple[str, ...]


def read_written_sheet(path: Path) -> SheetReading:
    """Read the Pugh and Kesselring matrices of a workbook or a CSV file by their shape, one a sheet.

    Parameters
    ----------
    path : Path
        ``.xlsx`` or ``.xlsm``, else text with separators. Sheets may have any name, titles, notes,
        totals, and criteria down or across.

    Returns
    -------
    SheetReading
        A sheet of other numbers next to a matrix, without a word of decisions, is left out and named.

    Raises
    ------
    InputError
        With sheet, cell and remedy: no matrix, more than one reading, values that belong to no name, a wrong mark,
        weight or points. As :func:`~torquerig.safe_workbook.read_workbook` too.
    """
    grids = workbook_grids(path) if path.suffix.lower() in (".xlsx", ".xlsm") else [text_grid(path)]
    tables, said, failed = [], [], None
    for grid in grids:
        try:
            lines = oriented_lines(grid)
            found = None if lines is None else _table(lines, name=grid.sheet or path.stem)
        except InputError as error:
            if has_decision_word(grid):
                raise
            failed = failed or error
            said.append(f"sheet {grid.sheet!r}: is no matrix and was not read ({error})")
            continue
        if found is None:
            said.append(f"sheet {grid.sheet!r}: has no matrix and was not read")
            continue
        tables.append(found[0])
        said += found[1]
    if failed is not None and not tables:
        raise failed
    if not tables:
        raise InputError(
            f"{path}: has no decision matrix; write the alternatives in one row, the criteria in one column, and marks "
            "or points between them; torquerig matrix --template pugh FILE.xlsx writes an example"
        )
    return SheetReading(tables=TableSet(tables=tuple(tables)), understood=tuple(said))


def _table(lines: Lines, *, name: str) -> tuple[MatrixTable, list[str]]:
    grid = lines.grid
    if not lines.rated or not lines.criteria:
        raise InputError(f"{grid.origin}: no alternative has a mark or points; fill in the matrix, with ? for unknown")
    refuse_unread_ratings(lines)
    method, lines = method_of(lines)
    if not lines.rated:
        raise InputError(f"{grid.origin}: there is no alternative but the datum; add a column with marks")
    weights, way = None, ""
    if lines.weights is not None:
        weights, way = weights_of(grid, list(lines.criteria), lines.weights, lines.block.header)
    elif method is Method.KESSELRING:
        weights = [1.0] * len(lines.criteria)
    profile = profile_of(lines) if method is Method.KESSELRING else None
    table = _matrix_table(lines, method, weights, profile, name)
    _refuse_second_table(lines)
    refuse_unnamed_result(lines, table)
    refuse_hidden_weights(lines, table)
    refuse_weighted_total(lines, table)
    return table, understood(lines, table, way)


def _matrix_table(
    lines: Lines, method: Method, weights: list[float] | None, profile: Profile | None, name: str
) -> MatrixTable:
    grid = lines.grid
    held: Mapping[Spot, Entry] = marks_of(lines) if profile is None else points_of_cells(lines, profile)
    rows: list[Row] = []
    for place, (row, criterion) in enumerate(lines.criteria.items()):
        if criterion in [one.criterion for one in rows]:
            where = grid.place(row, lines.block.labels)
            raise InputError(f"{where}: the criterion {criterion!r} occurs twice; rename one of them")
        products = [grid.cells.get((row, lines.products.get(column, -1))) for column in lines.rated]
        rows.append(Row(
            criterion=criterion, entries=tuple(held.get((row, column), UNKNOWN) for column in lines.rated),
            place=grid.place(row, lines.block.labels), weight=None if weights is None else weights[place],
            products=_products(lines, row, products) if method is Method.KESSELRING else (),
        ))  # fmt: skip
    return MatrixTable(
        name=name, method=method, rows=tuple(rows), place=grid.origin,
        alternatives=tuple(lines.names[column] for column in lines.rated),
        baseline=("" if method is not Method.PUGH else NO_DATUM if lines.datum is None else lines.names[lines.datum]
                  or "datum"),
        profile=profile or TEACHING,
    )  # fmt: skip


def _products(lines: Lines, row: int, cells: list[object]) -> tuple[float | None, ...]:
    """Return weight times points as the weights count: a product with weights of 20 for 20 % is divided by 100."""
    if not lines.products or lines.weights is None:
        return ()
    found = weight_of(lines.grid.cells.get((row, lines.weights)))
    written = lines.grid.text(row, lines.weights)
    scale = 0.01 if found is not None and found[1] and "%" in written else 1.0
    numbers = [number_of(cell) for cell in cells]
    points = [number_of(lines.grid.cells.get((row, column))) for column in lines.rated]
    as_percent = [
        None if number is None or point is None or found is None else
        number * 0.01 if abs(number - point * found[0]) > abs(number * 0.01 - point * found[0]) else number
        for number, point in zip(numbers, points, strict=True)
    ]  # fmt: skip
    return tuple(as_percent if scale < 1 else numbers)


def _refuse_second_table(lines: Lines) -> None:
    """Raise InputError where the cells that nothing has read hold one more matrix."""
    grid, used = lines.grid, used_cells(lines)
    rest = {spot: value for spot, value in grid.cells.items() if spot not in used}
    other = Grid(path=grid.path, sheet=grid.sheet, cells=rest, is_turned=grid.is_turned)
    block = largest_block(other)
    if block is not None and block.is_table:
        place = grid.name(block.header, block.labels)
        raise InputError(
            f"{grid.origin}: there is a second table at {place}; use one sheet for each matrix, or clear "
            "what is no part of it"
        )
