"""Numbers in rows of text: separator and decimal sign are detected, a faulty row is reported with its line."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError

_NO_NUMBER = ("", "nan", "na", "n/a", "#n/a", "null")


@dataclass(frozen=True)
class Dialect:
    """The separator of the cells and the decimal sign of the numbers."""

    separator: str
    decimal: str

    def cells(self, line: str) -> list[str]:
        """Return the cells of one line, without blanks and quotes around them."""
        row = next(csv.reader([line.strip("\r\n")], delimiter=self.separator, skipinitialspace=True), [""])
        return [cell.strip() for cell in row]

    def number(self, cell: str) -> float | None:
        """Return the number in a cell, NaN where it is empty, None where it is not a number."""
        if cell.lower() in _NO_NUMBER:
            return float("nan")
        if self.decimal == "," and "." in cell:
            return None
        try:
            return float(cell.replace(self.decimal, ".")) if "_" not in cell else None
        except ValueError:
            return None


@dataclass(frozen=True)
class Text:
    """A text file, split into header and rows of numbers.

    Parameters
    ----------
    path : Path
        For messages.
    names : list of str
        The header's cells; empty where the first row is numbers.
    dialect : Dialect
        Separator and decimal sign of header and body.
    body : bytes
        The rows of numbers.
    first_line : int
        The line of the body's first row in the file, from 1.
    start : int
        The byte of the file where the body begins.
    """

    path: Path
    names: list[str]
    dialect: Dialect
    body: bytes
    first_line: int
    start: int = 0


def read_delimited(path: Path) -> Text:
    """Read a text file of rows; lines at the top that start with # or % are skipped, and a header may follow.

    Blanks separate the cells where no semicolon, tab or comma does. A comma is the decimal sign where something else
    separates the cells.
    """
    return _split(path, path.read_bytes())


def read_head(path: Path, size: int) -> Text:
    """Read the whole lines among the first ``size`` bytes, as :func:`read_delimited`."""
    with path.open("rb") as file:
        data = file.read(size)
    return _split(path, data if len(data) < size else data[: data.rfind(b"\n") + 1])


def texts_of(head: Text, step: int) -> Iterator[Text]:
    """Yield the body of a large file in pieces of complete lines, about ``step`` bytes each."""
    line, remainder = head.first_line, b""
    with head.path.open("rb") as file:
        file.seek(head.start)
        while data := file.read(step):
            data = remainder + data
            end = data.rfind(b"\n") + 1
            body, remainder = data[:end], data[end:]
            if end:
                yield _piece(head, body, line)
                line += body.count(b"\n")
    if remainder.strip():
        yield _piece(head, remainder, line)


def _piece(head: Text, body: bytes, line: int) -> Text:
    return replace(head, body=_single_blanks(body) if head.dialect.separator == " " else body, first_line=line)


def _split(path: Path, data: bytes) -> Text:
    whole = len(data)
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise RecordingError(f"{path}: the text is UTF-16; save it as UTF-8")
    if b"\0" in data[:4096]:
        raise RecordingError(f"{path}: is binary, not text; give it the ending of its format (.tdms, .mat, ...)")
    data = data.removeprefix(b"\xef\xbb\xbf")
    start = re.match(rb"(?:[ \t]*(?:[#%][^\n]*)?\r?\n)*", data)
    skipped = start.end() if start else 0
    begin = whole - len(data) + skipped
    first, _, rest = data[skipped:].partition(b"\n")
    header, line = _decoded(first), data.count(b"\n", 0, skipped) + 1
    unquoted = re.sub(r'"[^"]*"', "", header)
    separator = next((sign for sign in ";\t" if sign in unquoted), None)
    if separator is None:
        separator = _comma_or_blank(header, rest)
    if separator == " ":
        header, rest = " ".join(header.split()), _single_blanks(rest)
    decimal = "," if separator != "," and (b"," in rest or "," in header) else "."
    dialect = Dialect(separator, decimal)
    if all(dialect.number(cell) is not None for cell in dialect.cells(header)):
        return Text(path, [], dialect, header.encode() + b"\n" + rest, line, begin)
    return Text(path, dialect.cells(header), dialect, rest, line + 1, begin + len(first) + 1)


def numbers(text: Text, names: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    """Return the columns of numbers by ``names``; columns that begin and end with a word are ignored.

    Raises
    ------
    RecordingError
        With the line and the remedy, for a row of more or fewer cells or a cell that is not a number.
    """
    return parsed(text, names, number_columns(text, names))


def number_columns(text: Text, names: Sequence[str]) -> list[str]:
    """Return the names of the columns that do not begin and end with a word."""
    first = text.dialect.cells(_decoded(text.body.lstrip().partition(b"\n")[0]))
    last = text.dialect.cells(_decoded(text.body.rstrip().rpartition(b"\n")[2]))
    ends = zip(names, first, last, strict=False)
    words = [name for name, *cells in ends if all(_is_word(text.dialect, cell) for cell in cells)]
    return [name for name in names if name not in words]


def parsed(text: Text, names: Sequence[str], kept: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    """Return the columns ``kept`` among ``names``; RecordingError with the line as in :func:`numbers`."""
    if not text.body.strip():
        return {name: np.empty(0) for name in kept}
    quick = _parsed_quickly(text, names, kept) if kept and text.dialect.separator else None
    return quick if quick is not None else _parsed_by_line(text, names, kept)


def _parsed_quickly(text: Text, names: Sequence[str], kept: Sequence[str]) -> dict[str, NDArray[np.float64]] | None:
    import pyarrow as pa
    from pyarrow import csv

    try:
        table = csv.read_csv(
            pa.BufferReader(text.body),
            read_options=csv.ReadOptions(column_names=list(names)),
            parse_options=csv.ParseOptions(delimiter=text.dialect.separator),
            convert_options=csv.ConvertOptions(
                column_types={name: pa.float64() for name in kept},
                include_columns=list(kept),
                decimal_point=text.dialect.decimal,
            ),
        )
    except pa.ArrowInvalid:
        return None
    return {name: np.asarray(table[name].to_numpy(), dtype=np.float64) for name in kept}


def _parsed_by_line(text: Text, names: Sequence[str], kept: Sequence[str]) -> dict[str, NDArray[np.float64]]:
    columns: dict[str, list[float]] = {name: [] for name in kept}
    for count, line in enumerate(_decoded(text.body).splitlines()):
        if not line.strip():
            continue
        place = f"{text.path}:{text.first_line + count}"
        cells = text.dialect.cells(line)
        if len(cells) != len(names):
            raise RecordingError(
                f"{place}: the row has {len(cells)} cell{'s' * (len(cells) != 1)} and the table {len(names)} columns; "
                f"complete or delete the row{_comma_hint(text.dialect, cells)}"
            )
        for name, cell in zip(names, cells, strict=True):
            if name in columns:
                number = text.dialect.number(cell)
                if number is None:
                    raise RecordingError(f"{place}: {name}: {cell!r} is no number; correct the cell or delete the row")
                columns[name].append(number)
    return {name: np.array(values, dtype=np.float64) for name, values in columns.items()}


def _comma_or_blank(header: str, rest: bytes) -> str:
    """Return the separator of a line that has neither semicolon nor tab."""
    second = _decoded(rest.lstrip().partition(b"\n")[0])
    blanks = len(header.split()) == len(second.split() or header.split()) > 1
    if blanks and ("," not in header or header.count(",") != len(header.split()) - 1):
        return " "
    # one column: a comma in a row below a header without one is the decimal sign
    return ";" if "," not in header else ","


def _comma_hint(dialect: Dialect, cells: Sequence[str]) -> str:
    commas = dialect.separator == "," and len(cells) > 1 and all(cell.lstrip("+-").isdigit() for cell in cells)
    return " (if the commas are decimal signs, separate the cells by semicolons)" if commas else ""


def _is_word(dialect: Dialect, cell: str) -> bool:
    return dialect.number(cell) is None and not any(sign.isdigit() for sign in cell)


def _single_blanks(data: bytes) -> bytes:
    return re.sub(rb"[ \t]+", b" ", re.sub(rb"(?m)^[ \t]+|[ \t\r]+$", b"", data))


def _decoded(data: bytes) -> str:
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")
