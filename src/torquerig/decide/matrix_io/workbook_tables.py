"""The tables of an Excel workbook: heads, rows and cell names, with formulas as their stored values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.errors import InputError, did_you_mean
from torquerig.safe_workbook import Row, column_letters, read_workbook


@dataclass(frozen=True, kw_only=True)
class SheetTable:
    """One sheet: its heads with their columns, and its rows with their numbers."""

    name: str
    heads: Mapping[str, int]
    rows: tuple[tuple[int, Row], ...]

    def records(self) -> Iterator[tuple[int, dict[str, Any]]]:
        """Yield the number of each row that is not empty, and its entries by head."""
        for number, row in self.rows:
            held = {head: row[column] for head, column in self.heads.items() if column < len(row)}
            held = {head: value for head, value in held.items() if value is not None and value != ""}
            if held:
                yield number, held

    def cell(self, number: int, head: str) -> str:
        """Return the place of a cell in words."""
        return f"sheet {self.name!r}, cell {column_letters(self.heads.get(head, 0))}{number}"


def sheet_tables(path: Path, names: Collection[str]) -> dict[str, SheetTable]:
    """Return those of the named sheets that the workbook has; the heads are in the first row.

    Raises
    ------
    InputError
        As :func:`~torquerig.safe_workbook.read_workbook`, and where a head occurs twice.
    """
    tables = {}
    for name, rows in read_workbook(path, names).items():
        head = rows[0][1] if rows and rows[0][0] == 1 else ()
        heads: dict[str, int] = {}
        for column, text in enumerate(head):
            if text is None or str(text).strip() == "":
                continue
            title = str(text).strip()
            if title in heads:
                where = f"{path}: sheet {name!r}, cell {column_letters(column)}1"
                raise InputError(f"{where}: the column {title!r} occurs twice; keep one of them")
            heads[title] = column
        tables[name] = SheetTable(name=name, heads=heads, rows=tuple(row for row in rows if row[0] > 1))
    return tables


def needed_table(path: Path, book: Mapping[str, SheetTable], name: str, heads: Collection[str]) -> SheetTable:
    """Return a sheet that must be there and have these columns; InputError names what is missing."""
    if name not in book:
        raise InputError(f"{path}: the sheet {name!r} is missing; write a sheet with --out and fill that in")
    table = book[name]
    for head in heads:
        if head not in table.heads:
            known = [one for one in table.heads if one not in heads]
            close = did_you_mean(head, known) if known else ""
            hint = close if close.startswith("did you mean") else "add it to the first row"
            raise InputError(f"{path}: sheet {name!r}: the column {head!r} is missing; {hint}")
    return table


def refuse_unknown(path: Path, table: SheetTable, known: set[str]) -> None:
    """Raise InputError for a column that nothing reads."""
    for head, column in table.heads.items():
        if head not in known:
            place = f"{path}: sheet {table.name!r}, cell {column_letters(column)}1"
            raise InputError(f"{place}: unknown column {head!r}; {did_you_mean(head, known)}")
