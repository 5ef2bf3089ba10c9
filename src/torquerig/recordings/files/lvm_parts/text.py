"""The text of an LVM file: tags, labels and rows of each segment, with the line of a faulty row."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.lvm_parts.rows import Rows, decoded
from torquerig.recordings.files.text_tables.cells import Dialect

END = b"***End_of_Header***"
X_LABEL = "X_Value"
# rows above a last one that are enough to see that it is cut off
_COMPARED = 20
_SPECIAL = re.compile(rb"^\*\*\*Start_Special.*?(?:^\*\*\*End_Special[^\n]*|\Z)", re.DOTALL | re.MULTILINE)


@dataclass(frozen=True, kw_only=True)
class Segment:
    """One call of LabVIEW's writer.

    Parameters
    ----------
    tags : mapping of str to list of str
        The rows of its header: the cells that follow the tag.
    labels : list of str
        The labels of the columns as written, without the column of remarks.
    columns : list of ndarray, shape (rows,), float64
        The numbers, NaN where a cell is blank.
    blank : list of ndarray, shape (rows,), bool
        Where a cell is blank.
    decimals : int
        Decimal places of the printed X values.
    has_remarks : bool
        Whether a row has text in the column of remarks.
    note : str
        Why the file seems to be cut short; empty where it does not.
    """

    tags: Mapping[str, list[str]]
    labels: list[str]
    columns: list[NDArray[np.float64]]
    blank: list[NDArray[np.bool_]]
    decimals: int
    has_remarks: bool
    note: str = ""


def segments_of(path: Path) -> list[Segment]:
    """Return the segments of a file.

    Raises
    ------
    RecordingError
        With the line: no LVM header, no labels, a faulty row, a comma that both separates cells and marks decimals.
    """
    data = _plain_lines(path.read_bytes())
    if not data.startswith(b"LabVIEW Measurement"):
        raise RecordingError(f"{path}:1: the first line is not 'LabVIEW Measurement'; rename the file to .txt or .csv")
    ends = list(_ends(data))
    if not ends:
        raise RecordingError(f"{path}: it has no {END.decode()}; the file is incomplete, copy it again from its source")
    head = decoded(data[: ends[0][0]])
    sign = re.search(r"^Separator([\t,;| ])", head, re.MULTILINE)
    separator = sign[1] if sign else "\t"
    tags = {cells[0]: cells[1].strip() for line in head.splitlines()[1:] if len(cells := line.split(separator)) > 1}
    dialect = Dialect(separator, tags.get("Decimal_Separator") or ".")
    if (
        dialect.decimal not in (".", ",")
        or dialect.decimal == separator
        or f"\nDecimal_Separator{separator * 2}" in head
    ):
        raise RecordingError(
            f"{path}: the sign {separator!r} separates the cells and {tags.get('Decimal_Separator')!r} marks the "
            "decimals, which cannot be told apart; save the file with tabs and decimal points"
        )
    spans = _header_spans(data, ends, separator.encode())
    segments, line, counted = [], 1, 0
    for begin, end, close in spans:
        line, counted = line + data.count(b"\n", counted, end), end
        segment = _segment(path, data, dialect, begin=begin, end=end, close=close, line=line)
        segments += [] if segment is None else [segment]
    if not segments:
        raise RecordingError(f"{path}: there is no line of labels that starts with {X_LABEL}; the file has no data")
    return segments


def _ends(data: bytes) -> Iterator[tuple[int, int]]:
    """Yield begin and end of each line that closes a header."""
    place = data.find(b"\n" + END)
    while place >= 0:
        close = data.find(b"\n", place + 1)
        yield place + 1, len(data) if close < 0 else close + 1
        place = data.find(b"\n" + END, place + 1)


def _plain_lines(data: bytes) -> bytes:
    data = data.removeprefix(b"\xef\xbb\xbf")
    if b"\r" in data[:4096]:
        data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    # special blocks hold binary data of other programs; their lines are kept blank for the line numbers
    return _SPECIAL.sub(lambda found: b"\n" * found[0].count(b"\n"), data) if b"***Start_Special" in data else data


def _header_spans(data: bytes, ends: list[tuple[int, int]], separator: bytes) -> Iterator[tuple[int, int, int]]:
    """Yield begin and end of each segment's header, and the end of its rows; the first segment may have no header."""
    first = ends[0][1]
    if (
        len(ends) == 1
        or data.startswith(X_LABEL.encode(), first)
        or b"\n" + X_LABEL.encode() in data[first : ends[1][0]]
    ):
        headers = [(first, first), *((_header_begin(data, start, separator), end) for start, end in ends[1:])]
    else:
        headers = [(first, ends[1][1]), *((_header_begin(data, start, separator), end) for start, end in ends[2:])]
    closes = [*(begin for begin, _ in headers[1:]), len(data)]
    for (begin, end), close in zip(headers, closes, strict=True):
        yield begin, end, close


def _header_begin(data: bytes, end: int, separator: bytes) -> int:
    """Return where the lines of tags, which begin with a word, begin above ``end``."""
    begin = end
    while begin > 0:
        line = data.rfind(b"\n", 0, begin - 1) + 1
        first = data[line : begin - 1].split(separator)[0].strip()
        if not first[:1].isalpha() or first.lower() in (b"nan", b"inf", b"infinity"):
            break
        begin = line
    return begin


def _segment(
    path: Path, data: bytes, dialect: Dialect, *, begin: int, end: int, close: int, line: int
) -> Segment | None:
    tags = {
        cells[0].strip(): [cell.strip() for cell in cells[1:]]
        for line in decoded(data[begin:end]).splitlines()
        if (cells := line.split(dialect.separator))[0].strip()
    }
    found = re.compile(rb"\S").search(data, end, close)
    if found is None:
        return None
    start = data.rfind(b"\n", 0, found.start()) + 1
    first, _, body = data[start:close].partition(b"\n")
    labels = [cell.strip() for cell in decoded(first).rstrip().split(dialect.separator)]
    number = line + data.count(b"\n", end, start)
    if labels[0] != X_LABEL:
        raise RecordingError(
            f"{path}:{number}: a row of numbers comes before the line of labels that starts with {X_LABEL}; save the "
            "file again"
        )
    body, note = _without_cut_row(body, tags, labels, dialect)
    rows = Rows(path, number + 1, body, labels, dialect, _fewer(tags, labels))
    columns, blank, has_remarks = rows.parsed()
    return Segment(
        tags=tags,
        labels=labels[: rows.width],
        columns=columns,
        blank=blank,
        decimals=_decimals(body, dialect),
        has_remarks=has_remarks,
        note=note,
    )


def _without_cut_row(
    body: bytes, tags: Mapping[str, list[str]], labels: list[str], dialect: Dialect
) -> tuple[bytes, str]:
    """Return the rows without a last one that may end within a number, and a sentence about it.

    LabVIEW ends each row with a line end, and states the number of rows in ``Samples``.
    """
    rows = sum(1 for line in body.split(b"\n") if line.strip())
    stated = max(counts_of(aligned(tags, labels).get("Samples", {})).values(), default=0)
    ends = [decoded(line).rstrip("\r") for line in body.split(b"\n")[-_COMPARED - 1 :]]
    # a row without its last cells is refused with its line
    is_open = rows > 1 and bool(ends[-1]) and len({line.count(dialect.separator) for line in ends[-2:]}) == 1
    is_short = 0 < rows < stated
    is_cut = is_open and (is_short or _ends_early(ends, dialect))
    if not is_short and not is_cut:
        return body, ""
    parts = [f"the header states {stated} samples and the file has {rows} rows: it is cut short"] if is_short else []
    parts += ["the last row has no line end and its last number may be cut off; it is not read"] if is_cut else []
    return body[: body.rfind(b"\n") + 1] if is_cut else body, "; ".join(parts)


def _ends_early(lines: list[str], dialect: Dialect) -> bool:
    """Return whether the last number has fewer decimals than all of those at the ends of the rows above it."""
    ends = [line.rstrip().rpartition(dialect.separator)[2] for line in lines]
    decimals = [len(end.partition(dialect.decimal)[2]) for end in ends if end]
    return len(set(decimals[:-1])) == 1 and decimals[-1] < decimals[0]


def aligned(tags: Mapping[str, list[str]], labels: list[str]) -> dict[str, dict[int, str]]:
    """Return the header's cells by the column that they describe.

    LabVIEW leaves the cell over an X column blank (``Y_Unit_Label, Nm, , deg``). Other writers list the channels
    without gaps; a filled cell at an X column shows that.
    """
    channels = [index for index, label in enumerate(labels) if label != X_LABEL]
    known = [tags[tag] for tag in ("Delta_X", "X0", "X_Dimension", "Samples", "Y_Unit_Label") if tag in tags]
    gapless = any(
        cells[index - 1 : index] not in ([], [""]) for cells in known for index in range(1, len(labels))
        if labels[index] == X_LABEL
    )  # fmt: skip
    places = {column: order if gapless else column - 1 for order, column in enumerate(channels)}
    return {
        tag: {column: cells[place] for column, place in places.items() if place < len(cells)}
        for tag, cells in tags.items()
    }


def counts_of(cells: Mapping[int, str]) -> dict[int, int]:
    """Return the whole numbers in the header's cells, by column; more than 15 digits are no count of samples."""
    return {column: int(cell) for column, cell in cells.items() if cell.isascii() and cell.isdigit() and len(cell) < 16}


def _fewer(tags: Mapping[str, list[str]], labels: list[str]) -> dict[int, int]:
    """Return the stated number of samples of the columns that have fewer than the longest, with their X columns."""
    stated = counts_of(aligned(tags, labels).get("Samples", {}))
    longest = max(stated.values(), default=0)
    fewer = {column: count for column, count in stated.items() if count < longest}
    fewer |= {column - 1: count for column, count in fewer.items() if column > 1 and labels[column - 1] == X_LABEL}
    return fewer


def _decimals(body: bytes, dialect: Dialect) -> int:
    """Return the decimal places of the X values in the first rows; their last digit is a rounding error."""
    most = 0
    for line in body[:8192].split(b"\n")[:50]:
        cell = decoded(line).split(dialect.separator)[0].strip().upper().replace(dialect.decimal, ".")
        mantissa, _, exponent = cell.partition("E")
        places = len(mantissa.partition(".")[2])
        if exponent.isascii() and exponent.lstrip("+-").isdigit() and len(exponent) < 6:
            places -= int(exponent)
        most = max(most, min(places, 300))
    return most
