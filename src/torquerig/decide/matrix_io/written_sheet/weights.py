"""The weights of a sheet: fractions, per cent or plain numbers, and columns of weight times points."""

from __future__ import annotations

from collections.abc import Sequence

from torquerig.decide.matrix_io.written_sheet.grid import Grid
from torquerig.decide.matrix_io.written_sheet.words import unit_in_name
from torquerig.decide.matrix_io.written_values import LEVELS, may_be_thousands, number_of, pugh_mark, weight_of
from torquerig.errors import InputError

SUMS_TO_ONE = 0.02  # [1] rounding of weights that were written with two digits
MOST_POINTS = 10  # the widest common points scale; a wider one must be stated
HIGHEST_FRACTIONS, LOWEST_PERCENTS = 1.5, 50.0  # [1] sums of weights between which the unit % decides nothing


def weights_of(grid: Grid, rows: Sequence[int], column: int, header: int) -> tuple[list[float], str]:
    """Return the weights of the rows, and how they were written, in words.

    Numbers under a head with ``%`` are per cent where they sum to about 100, and fractions (a cell with the format per
    cent holds one) where they sum to about 1.

    Raises
    ------
    InputError
        A weight is missing, no number, negative, or may be a thousand; plain numbers and per cent are mixed; all are 0.
    """
    read = [(row, _weight(grid, row, column)) for row in rows]
    percent = [row for row, (_, is_percent) in read if is_percent]
    above_one = [row for row, (value, is_percent) in read if not is_percent and value > 1]
    if percent and above_one:
        raise InputError(
            f"{grid.place(above_one[0], column)}: {grid.text(above_one[0], column)!r} may be a weight of "
            f"{read[rows.index(above_one[0])][1][0]:g} or of as many per cent, as {grid.name(percent[0], column)} has "
            "a % sign; write all weights in one way"
        )
    values = [value for _, (value, _) in read]
    if not any(values):
        raise InputError(f"{grid.place(rows[0], column)}: all weights are 0; give one criterion a positive weight")
    if percent:
        return values, "in per cent"
    if "%" in unit_in_name(grid.text(header, column)) or grid.text(header, column).rstrip().endswith("%"):
        return _of_percent_head(grid, rows, column, values)
    return values, "as written"


def _of_percent_head(grid: Grid, rows: Sequence[int], column: int, values: list[float]) -> tuple[list[float], str]:
    total = sum(values)
    if HIGHEST_FRACTIONS < total < LOWEST_PERCENTS:
        raise InputError(
            f"{grid.place(rows[0], column)}: the weights sum to {total:g} under a head with %; they may be per cent or "
            "plain numbers; remove the % from the head, or make them sum to 100"
        )
    if total >= LOWEST_PERCENTS:
        return [value / 100 for value in values], "in per cent"
    return values, "as fractions"


def _weight(grid: Grid, row: int, column: int) -> tuple[float, bool]:
    cell = grid.cells.get((row, column))
    found = weight_of(cell)
    where = grid.place(row, column)
    if found is None:
        what = "is missing" if cell is None else f"{str(cell)[:40]!r} is no number"
        raise InputError(
            f"{where}: the weight {what}; write 20 %, 0.2 or 20, or name the line sum, mean or rank if it is a result"
        )
    if may_be_thousands(cell):
        digits = "".join(one for one in str(cell) if one.isdigit())
        raise InputError(f"{where}: {cell!r} may be {found[0]:g} or {digits}; write the weight without a separator")
    if found[0] < 0:
        raise InputError(f"{where}: the weight {found[0]:g} must be at least 0; turn the criterion round")
    return found


def are_surely_weights(grid: Grid, rows: Sequence[int], column: int, others: Sequence[int]) -> bool:
    """Return whether numbers can only be weights, not the ratings of a criterion such as the mass.

    They are per cent, fractions with the sum 1, larger than points, or numbers above 2 among marks.
    """
    read = [found for row in rows if (found := weight_of(grid.cells.get((row, column)))) is not None]
    values = [value for value, _ in read]
    if not values or len(values) < len(rows) or min(values) < 0:
        return False
    if are_shares(grid, rows, column):
        return True
    rated = [cell for row in rows for other in others if (cell := grid.cells.get((row, other))) is not None]
    numbers = [number for cell in rated if (number := number_of(cell)) is not None]
    if 2 * len(numbers) < len(rated):
        return max(values) > max(LEVELS.values())
    return max(values) > MOST_POINTS >= max(numbers, default=0.0)


def are_shares(grid: Grid, rows: Sequence[int], column: int) -> bool:
    """Return whether fractions or per cent sum to 1, with or without their sum as the last value."""
    read = [found for row in rows if (found := weight_of(grid.cells.get((row, column)))) is not None]
    values = [value for value, _ in read]
    if not read:
        return False
    is_fraction = any(percent or value % 1 for value, percent in read)
    sums = (sum(values), sum(values[:-1]))
    return is_fraction and min(values) >= 0 and any(abs(one - 1) < SUMS_TO_ONE for one in sums)


def is_product(grid: Grid, rows: Sequence[int], columns: tuple[int, int, int], *, share: float) -> bool:
    """Return whether at least ``share`` of a column is weight times points; weights may be per cent in it or not."""
    known = []
    for row in rows:
        points, product, weight = (grid.cells.get((row, column)) for column in columns)
        factor, result = weight_of(weight), number_of(product)
        level = LEVELS.get(pugh_mark(points) or "") if number_of(points) is None else number_of(points)
        if level is not None and result is not None and factor is not None:
            known.append((level * factor[0], result))
    rounding = SUMS_TO_ONE * max((abs(one) for one, _ in known), default=0.0) + 1e-9
    if len(known) < 2 or not any(result for _, result in known):
        return False
    return any(
        sum(abs(one * scale - result) <= rounding * scale for one, result in known) >= share * len(known)
        for scale in (1.0, 0.01, 100.0)
    )
