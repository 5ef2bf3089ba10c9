"""Excel workbooks read within limits: no file makes the reader hang, fill the memory or end in a traceback."""

from __future__ import annotations

import zipfile
from collections.abc import Collection, Iterator
from contextlib import ExitStack
from io import BytesIO
from itertools import zip_longest
from pathlib import Path
from typing import Any
from warnings import catch_warnings, simplefilter

from torquerig.errors import InputError
from torquerig.safe_yaml import beyond_calculation

LARGEST_PARTS = (
    10_000_000  # [byte] the XML of a workbook, unpacked; a shipped one has 120 000, openpyxl takes 3 s for it
)
LARGEST_FILE = 50_000_000  # [byte] packed, with pictures
LAST_ROW = 10_000  # rows of a table that a person fills in
LAST_COLUMN = 1_000
MOST_PARTS = 5_000  # files in the archive

Row = tuple[Any, ...]


def read_workbook(path: Path, names: Collection[str] | None = None) -> dict[str, tuple[tuple[int, Row], ...]]:
    """Return the rows of the named sheets (all when not given) that are not empty, each with its number from 1.

    A formula counts with the value that the spreadsheet program stored with it. Empty cells at the end of a row are
    left out.

    Raises
    ------
    InputError
        With sheet and cell: no workbook, damaged, unpacked larger than ``LARGEST_PARTS``, with a document type (which
        can repeat text without end), an entry far from the table, a number no calculation can hold, a formula without a
        stored value.
    """
    import openpyxl

    if not path.is_file():
        raise InputError(f"{path}: there is no such file; check the path")
    content = _safe_content(path)
    with ExitStack() as stack, catch_warnings():
        simplefilter("ignore")  # openpyxl warns of drop-downs and pictures that it does not keep
        try:
            values, formulas = (
                openpyxl.load_workbook(BytesIO(content), data_only=only, read_only=True) for only in (True, False)
            )  # fmt: skip
            stack.callback(values.close)
            stack.callback(formulas.close)
            wanted = [one for one in values.worksheets if names is None or one.title in names]
            return {one.title: tuple(_rows(path, one, formulas[one.title])) for one in wanted}
        except InputError:
            raise
        except Exception as error:  # openpyxl has no error of its own for what is damaged
            raise InputError(f"{path}: is no whole Excel workbook ({_first_line(error)}); {_SAVE_AGAIN}") from None


_SAVE_AGAIN = "open it in a spreadsheet program and save it as .xlsx again"


def _safe_content(path: Path) -> bytes:
    """Return the bytes of a workbook whose parts are small and declare no document type."""
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{path}: has more than {LARGEST_FILE / 1e6:.0f} MB; copy the table into a new file")
        with zipfile.ZipFile(path) as archive:
            parts = [part for part in archive.infolist() if part.filename.lower().endswith((".xml", ".rels"))]
            size = sum(part.file_size for part in parts)
            if size > LARGEST_PARTS or len(archive.infolist()) > MOST_PARTS:
                raise InputError(
                    f"{path}: unpacks to {size / 1e6:.0f} MB in {len(archive.infolist())} parts, more than the "
                    f"{LARGEST_PARTS / 1e6:.0f} MB of a table that is filled in by hand; copy the table into a new file"
                )
            for part in parts:
                text = archive.read(part).replace(b"\0", b"").lower()  # UTF-16 has a NUL in each letter
                if b"<!doctype" in text or b"<!entity" in text:
                    raise InputError(f"{path}: the part {part.filename!r} declares a document type, which no "
                                     f"spreadsheet program writes; {_SAVE_AGAIN}")  # fmt: skip
        return path.read_bytes()
    except InputError:
        raise
    except Exception as error:  # zipfile and zlib have several, and a damaged directory gives any
        raise InputError(f"{path}: is no Excel workbook ({_first_line(error)}); {_SAVE_AGAIN}") from None


def _rows(path: Path, values: Any, formulas: Any) -> Iterator[tuple[int, Row]]:
    values.reset_dimensions()  # the stated ones may be those of an empty sheet of a million rows
    formulas.reset_dimensions()
    pairs = zip_longest(values.iter_rows(), formulas.iter_rows(values_only=True), fillvalue=())
    for number, (cells, written) in enumerate(pairs, start=1):
        stored = tuple(_stored(cell) for cell in cells)
        row = _without_end(stored)
        if not row and not _without_end(written):
            continue
        _refuse_far(path, values.title, number, len(row))
        for column, (value, live) in enumerate(zip_longest(stored, written)):
            problem = _problem(value, live)
            if problem:
                raise InputError(f"{path}: sheet {values.title!r}, cell {column_letters(column)}{number}: {problem}")
        yield number, row


def _stored(cell: Any) -> Any:
    """Return the value of a cell; a formula whose stored result is an empty text has this type and no value."""
    return "" if cell.value is None and cell.data_type == "str" else cell.value


def _problem(value: Any, live: Any) -> str | None:
    if value is None and isinstance(live, str) and live.startswith("="):
        return (
            f"the formula {live} has no stored value; open and save the file in a spreadsheet program, or write the "
            "number"
        )
    if isinstance(value, int | float) and not isinstance(value, bool):
        problem = beyond_calculation(value)
        return f"{value:g} {problem}" if problem else None
    return None


def _refuse_far(path: Path, sheet: str, number: int, columns: int) -> None:
    if number > LAST_ROW or columns > LAST_COLUMN:
        cell = f"{column_letters(max(columns, 1) - 1)}{number}"
        raise InputError(
            f"{path}: sheet {sheet!r}, cell {cell}: this entry is far from the table, which may reach to row "
            f"{LAST_ROW} and column {column_letters(LAST_COLUMN - 1)}; clear the cell"
        )


def _without_end(row: Row) -> Row:
    last = len(row)
    while last and row[last - 1] in (None, ""):
        last -= 1
    return row[:last]


def column_letters(column: int) -> str:
    """Return the letters of a column counted from 0: A, B, ..., Z, AA."""
    text = ""
    column += 1
    while column:
        column, remainder = divmod(column - 1, 26)
        text = chr(ord("A") + remainder) + text
    return text


def _first_line(error: Exception) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]
