"""The tables of an Excel workbook: heads, rows and cell names, with formulas as their stored values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from torquerig.errors import InputError, did_you_mean

Row = tuple[Any, ...]


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
    """Return those of the named sheets that the workbook has; InputError where it is none, or a head occurs twice."""
    from zipfile import BadZipFile

    import openpyxl

    if not path.is_file():
        raise InputError(f"{path}: there is no such file; check the path")
    try:
        values, formulas = (openpyxl.load_workbook(path, data_only=only) for only in (True, False))
    except (BadZipFile, KeyError, ValueError, OSError) as error:
        raise InputError(f"{path}: is no Excel workbook ({error}); save it as .xlsx") from None
    tables = {}
    for name in names:
        if name not in values.sheetnames:
            continue
        rows = tuple(enumerate(values[name].iter_rows(values_only=True), start=1))
        _refuse_unstored(path, name, rows, formulas[name])
        head = rows[0][1] if rows else ()
        heads: dict[str, int] = {}
        for column, text in enumerate(head):
            if text is None or str(text).strip() == "":
                continue
            title = str(text).strip()
            if title in heads:
                where = f"{path}: sheet {name!r}, cell {column_letters(column)}1"
                raise InputError(f"{where}: the column {title!r} occurs twice; keep one of them")
            heads[title] = column
        tables[name] = SheetTable(name=name, heads=heads, rows=rows[1:])
    values.close()
    formulas.close()
    return tables


def _refuse_unstored(path: Path, name: str, rows: tuple[tuple[int, Row], ...], live: Any) -> None:
    for number, row in rows:
        for column, value in enumerate(row):
            written = live.cell(number, column + 1).value if value is None else None
            if isinstance(written, str) and written.startswith("="):
                place = f"{path}: sheet {name!r}, cell {column_letters(column)}{number}"
                raise InputError(f"{place}: the formula {written} has no stored value; open and save the file in a "
                                 "spreadsheet program, or write the number")  # fmt: skip


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


def column_letters(column: int) -> str:
    """Return the letters of a column counted from 0: A, B, ..., Z, AA."""
    text = ""
    column += 1
    while column:
        column, remainder = divmod(column - 1, 26)
        text = chr(ord("A") + remainder) + text
    return text
