"""What was understood of a sheet: which cells are alternatives, criteria, weights, datum and totals."""

from __future__ import annotations

from torquerig.decide.matrix_io.matrix_table import MatrixTable, Method
from torquerig.decide.matrix_io.written_sheet.grid import Grid, Spot, is_value
from torquerig.decide.matrix_io.written_sheet.lines import Lines
from torquerig.decide.matrix_io.written_sheet.totals import totals_compared, weight_total

SHOWN = 6  # cells that a sentence lists


def understood(lines: Lines, table: MatrixTable, weights: str) -> list[str]:
    """Return the sentences for one sheet; ``difference`` starts those on results that the cells do not give."""
    grid, header, labels = lines.grid, lines.block.header, lines.block.labels
    where = f"sheet {grid.sheet!r}" if grid.sheet else grid.path.name
    said = [
        f"{where}: read as a {table.method.value.capitalize()} matrix",
        f"alternatives: {grid.spans([(header, c) for c in lines.rated])} ({', '.join(table.alternatives)})",
        f"criteria: {grid.spans([(row, labels) for row in lines.criteria])}",
    ]
    if lines.weights is not None:
        spots = [(row, lines.weights) for row in lines.criteria]
        counted = "; they count in the weighted sum, next to the plain one" if table.method is Method.PUGH else ""
        said.append(f"weights: {grid.spans(spots)}, {weights}, with the sum {sum(table.weights):.6g}{counted}")
    elif table.method is Method.KESSELRING:
        said.append("weights: none, so that every criterion counts 1")
    said += _datum(lines, table)
    names = ", ".join(lines.names[column] for column in lines.products if column in lines.rated)
    if names:
        said.append(f"weight times points: next to the points of {names}; checked and not read again")
    said += totals_compared(lines, table)
    said += [text for row in lines.totals if (text := weight_total(lines, table.weights, row))]
    empty = [(row, c) for row in lines.criteria for c in lines.rated if (row, c) not in grid.cells]
    if empty:
        said.append(f"empty, so unknown: {_listed(grid, empty)}")
    return [*said, *_not_read(lines)]


def used_cells(lines: Lines) -> set[Spot]:
    """Return the cells that are names, values, weights, datum, products or totals."""
    grid, block = lines.grid, lines.block
    columns = {*lines.rated, *lines.products.values(), lines.weights, lines.datum, lines.ideal, block.labels} - {None}
    rows = {*lines.criteria, *lines.totals, block.header}
    return {(row, column) for row, column in grid.cells if row in rows and column in columns}


def _datum(lines: Lines, table: MatrixTable) -> list[str]:
    grid = lines.grid
    if table.method is not Method.PUGH:
        scale = table.profile
        if not scale.stated:
            return ["points scale: not stated"]
        ideal = "" if lines.ideal is None else f", by the ideal in {grid.name(lines.block.header, lines.ideal)}"
        return [f"points scale: {f'{scale.p_min:g} to' if lines.ideal is None else 'up to'} {scale.p_max:g}{ideal}"]
    graded = any(entry in ("++", "--") for row in table.rows for entry in row.entries)
    said = ["++ and -- count 2 and -2"] if graded else []
    if lines.datum is None:
        return [*said, "datum: not in the sheet, so the marks compare with something that has no column"]
    return [*said, f"datum: {table.baseline!r} in {grid.name(lines.block.header, lines.datum)}"]


def _not_read(lines: Lines) -> list[str]:
    grid, used = lines.grid, used_cells(lines)
    rest = sorted(spot for spot in grid.cells if spot not in used)
    values = [spot for spot in rest if is_value(grid.cells[spot])]
    texts = [spot for spot in rest if spot not in values]
    said = [f"numbers or marks that are not part of the matrix: {_listed(grid, values)}"] if values else []
    return [*said, *([f"text that was not read: {_listed(grid, texts)}"] if texts else [])]


def _listed(grid: Grid, spots: list[Spot]) -> str:
    shown = [f"{grid.name(*spot)} {grid.text(*spot)[:24]!r}" if spot in grid.cells else grid.name(*spot)
             for spot in spots[:SHOWN]]  # fmt: skip
    return ", ".join(shown) + (f" and {len(spots) - SHOWN} more" if len(spots) > SHOWN else "")
