"""The cells of one sheet, with their names in the file, read down or across."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from io import StringIO
from pathlib import Path
from typing import Any

from torquerig.decide.matrix_io.matrix_table import UNKNOWN
from torquerig.decide.matrix_io.written_values import number_of, pugh_mark, weight_of
from torquerig.errors import InputError
from torquerig.safe_workbook import column_letters, read_workbook

MOST_ROWS, MOST_COLUMNS = 400, 200  # filled rows and columns of a matrix that a person filled in
LARGEST_TEXT = 2_000_000  # [byte] of a sheet as text

Spot = tuple[int, int]


@dataclass(frozen=True, kw_only=True)
class Grid:
    """The filled cells of a sheet.

    Parameters
    ----------
    path : Path
    sheet : str
        Empty for a text file.
    cells : mapping of (row, column) to value
        Counted from 0, without empty cells.
    is_turned : bool
        Rows and columns of the file are exchanged here.
    """

    path: Path
    sheet: str
    cells: Mapping[Spot, Any]
    is_turned: bool = False

    @cached_property
    def rows(self) -> list[int]:
        """The rows that hold something, in order."""
        return sorted({row for row, _ in self.cells})

    @cached_property
    def columns(self) -> list[int]:
        """The columns that hold something, in order."""
        return sorted({column for _, column in self.cells})

    def turned(self) -> Grid:
        """Return the grid with rows and columns exchanged; names of cells stay those of the file."""
        cells = {(column, row): value for (row, column), value in self.cells.items()}
        return Grid(path=self.path, sheet=self.sheet, cells=cells, is_turned=not self.is_turned)

    def name(self, row: int, column: int) -> str:
        """Return ``B4``."""
        row, column = (column, row) if self.is_turned else (row, column)
        return f"{column_letters(column)}{row + 1}"

    def span(self, spots: Sequence[Spot]) -> str:
        """Return ``B4:B9``, the rectangle around the cells, or ``B4`` where there is one."""
        rows, columns = [row for row, _ in spots], [column for _, column in spots]
        first, last = self.name(min(rows), min(columns)), self.name(max(rows), max(columns))
        return first if first == last else f"{first}:{last}"

    def spans(self, spots: Sequence[Spot]) -> str:
        """Return the cells of one line as ``C3, E3:G3``."""
        runs: list[list[Spot]] = []
        for spot in spots:
            follows = runs and sum(abs(one - two) for one, two in zip(spot, runs[-1][-1], strict=True)) == 1
            runs[-1].append(spot) if follows else runs.append([spot])
        return ", ".join(self.span(run) for run in runs)

    @property
    def origin(self) -> str:
        """The file and the sheet, to start a sentence with."""
        return f"{self.path}: sheet {self.sheet!r}" if self.sheet else str(self.path)

    def place(self, row: int, column: int) -> str:
        """Return the file, the sheet and the cell."""
        return f"{self.origin}, cell {self.name(row, column)}"

    def text(self, row: int, column: int) -> str:
        """Return a cell as the text of a name; empty where it is empty."""
        value = self.cells.get((row, column), "")
        return f"{value:g}" if isinstance(value, float) else " ".join(str(value).split())

    def line_word(self, *, is_row: bool) -> str:
        """Return what a row of this grid is called in the file."""
        return "row" if is_row != self.is_turned else "column"


def is_value(value: Any) -> bool:
    """Return whether a cell can be a mark, points, a weight or a total, not a name."""
    if weight_of(value) is not None or pugh_mark(value) is not None:
        return True
    return isinstance(value, str) and value.strip() == UNKNOWN


def is_number(value: Any) -> bool:
    """Return whether a cell holds a number, also as text and in per cent."""
    return number_of(value) is not None or weight_of(value) is not None


def workbook_grids(path: Path) -> list[Grid]:
    """Return every sheet of a workbook that holds something; errors as ``read_workbook``."""
    found = []
    for name, rows in read_workbook(path).items():
        cells = {
            (number - 1, column): value
            for number, row in rows
            for column, value in enumerate(row)
            if value is not None and not (isinstance(value, str) and not value.strip())
        }
        if cells:
            found.append(_within_bounds(Grid(path=path, sheet=name, cells=cells)))
    return found


def text_grid(path: Path) -> Grid:
    """Return a sheet saved as CSV: semicolons, tabs or commas between the cells.

    Raises
    ------
    InputError
        Where the file is missing, larger than ``LARGEST_TEXT``, no text, or cannot be split in one way.
    """
    try:
        content = path.read_bytes() if path.stat().st_size <= LARGEST_TEXT else None
    except OSError as error:
        raise InputError(f"{path}: there is no such file to read ({error.strerror}); check the path") from None
    if content is None:
        raise InputError(f"{path}: has more than {LARGEST_TEXT / 1e6:.0f} MB; a matrix has a few hundred cells")
    text = _decoded(path, content)
    first, _, after = text.partition("\n")
    delimiter = first[4:5] if first.lower().startswith("sep=") else ""
    text = after if delimiter else text
    delimiter, skipped = delimiter or _delimiter(text), 1 if delimiter else 0
    try:
        rows = list(csv.reader(StringIO(text), delimiter=delimiter))
    except csv.Error as error:
        raise InputError(f"{path}: is no CSV table ({error}); save it again as CSV or .xlsx") from None
    if delimiter == ",":
        _refuse_shifted(path, rows, skipped)
    cells = {
        (number + skipped, column): value.strip()
        for number, row in enumerate(rows)
        for column, value in enumerate(row)
        if value.strip()
    }
    return _within_bounds(Grid(path=path, sheet="", cells=cells))


def _decoded(path: Path, content: bytes) -> str:
    codec = "utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig"
    for name in (codec, "cp1252"):
        try:
            text = content.decode(name)
        except UnicodeDecodeError:
            continue
        if "\0" not in text:
            return text.replace("\r\n", "\n").replace("\r", "\n")
    raise InputError(f"{path}: is no text file; save the sheet as CSV (UTF-8) or .xlsx")


def _delimiter(text: str) -> str:
    """Return what separates the cells; a comma only where there is neither semicolon nor tab, as it may be decimal."""
    lines = [line for line in text.split("\n") if line.strip()]
    for one in (";", "\t"):
        if sum(one in line for line in lines) * 2 > len(lines):
            return one
    return ","


def _refuse_shifted(path: Path, rows: list[list[str]], skipped: int) -> None:
    """Raise InputError for a row with more cells than most: a decimal comma without quotes shifts what follows."""
    lengths = [len(row) for row in rows if len(row) > 1]
    usual = max({*lengths}, key=lambda length: (lengths.count(length), length), default=0)
    for number, row in enumerate(rows, start=1 + skipped):
        if len(row) > usual:
            raise InputError(
                f"{path}:{number}: has {len(row)} cells where most lines have {usual}; a decimal comma between "
                "separating commas makes one cell two; save the sheet with semicolons, or as .xlsx"
            )


def _within_bounds(grid: Grid) -> Grid:
    rows, columns = len(grid.rows), len(grid.columns)
    if rows > MOST_ROWS or columns > MOST_COLUMNS:
        raise InputError(
            f"{grid.origin}: has {rows} filled rows and {columns} filled columns; a decision matrix has at most "
            f"{MOST_ROWS} and {MOST_COLUMNS}; copy the matrix into a new file"
        )
    return grid
