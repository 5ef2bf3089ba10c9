"""LVM, the LabVIEW measurement text: a file header, then segments of columns, each with its own header."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.files.delimited import Dialect
from torquerig.recordings.files.number_table import Table, distinct
from torquerig.recordings.files.timebase import shortest_rate

_END = "***End_of_Header***"


@dataclass
class _Segment:
    """One call of LabVIEW's writer: tags of its header, labels of its columns, and its rows."""

    tags: dict[str, list[str]]
    labels: list[str] = field(default_factory=list)
    rows: list[list[float]] = field(default_factory=list)

    def tag(self, name: str, index: int) -> str:
        cells = self.tags.get(name, [])
        return cells[index] if index < len(cells) else ""


def read_lvm(path: Path) -> Table:
    """Read all segments, one after the other; ``Delta_X`` gives the rate, else the column ``X_Value`` the time.

    With several segments the time column is kept, so that a gap between them is detected.

    Raises
    ------
    RecordingError
        With the line: no LVM header, a faulty row, segments of different channels.

    Source: National Instruments, "Specification for the LabVIEW Measurement File (.lvm)": tags Separator,
    Decimal_Separator, X_Columns, Delta_X, Y_Unit_Label; special blocks are skipped.
    """
    lines = path.read_text(encoding="utf-8", errors="replace").removeprefix("\ufeff").splitlines()
    if not lines or not lines[0].startswith("LabVIEW Measurement"):
        raise RecordingError(f"{path}:1: the first line is not 'LabVIEW Measurement'; rename the file to .txt or .csv")
    end = next((number for number, line in enumerate(lines) if line.startswith(_END)), None)
    if end is None:
        raise RecordingError(f"{path}: it has no {_END}; the file is incomplete, copy it again from its source")
    separator = "," if any(line.lower().startswith("separator,comma") for line in lines[:end]) else "\t"
    tags = {cells[0]: cells[1:] for cells in (line.split(separator) for line in lines[1:end])}
    dialect = Dialect(separator, (tags.get("Decimal_Separator") or ["."])[0].strip() or ".")
    segments = _segments(path, lines, end + 1, dialect)
    return _table(path, segments, x_columns=(tags.get("X_Columns") or ["One"])[0].strip().lower())


def _segments(path: Path, lines: list[str], start: int, dialect: Dialect) -> list[_Segment]:
    segments: list[_Segment] = []
    tags: dict[str, list[str]] = {}
    special = in_header = False
    for number, line in enumerate(lines[start:], start + 1):
        cells = line.split(dialect.separator)
        if line.startswith(("***Start_Special***", "***End_Special***")):
            special = line.startswith("***Start")
        elif special or not line.strip():
            continue
        elif line.startswith(_END):
            segments.append(_Segment(tags))
            tags, in_header = {}, False
        elif cells[0] == "Channels" or in_header:
            tags[cells[0]], in_header = [cell.strip() for cell in cells[1:]], True
        elif cells[0] == "X_Value":
            segments = segments or [_Segment({})]
            segments[-1].labels = [cell.strip() for cell in cells]
        elif segments and segments[-1].labels:
            segments[-1].rows.append(_row(f"{path}:{number}", cells, segments[-1].labels, dialect))
        else:
            raise RecordingError(
                f"{path}:{number}: a row of numbers comes before the line of labels that starts with X_Value; save the "
                "file again"
            )
    return segments


def _row(place: str, cells: list[str], labels: list[str], dialect: Dialect) -> list[float]:
    width = len(labels) - (labels[-1] == "Comment")
    if len(cells) < width:
        raise RecordingError(
            f"{place}: the row has {len(cells)} cells and the table {width} columns; complete or delete the row"
        )
    numbers = [dialect.number(cell.strip()) for cell in cells[:width]]
    for label, cell, number in zip(labels, cells, numbers, strict=False):
        if number is None:
            raise RecordingError(f"{place}: {label}: {cell!r} is no number; correct the cell or delete the row")
    return [number for number in numbers if number is not None]


def _table(path: Path, segments: list[_Segment], *, x_columns: str) -> Table:
    segments = [segment for segment in segments if segment.labels]
    if not segments:
        raise RecordingError(f"{path}: there is no line of labels that starts with X_Value; the file has no data")
    first = segments[0]
    if any(segment.labels != first.labels for segment in segments):
        raise RecordingError(f"{path}: its segments hold different channels; save each segment to a separate file")
    width = len(first.labels) - (first.labels[-1] == "Comment")
    rows = np.array([row for segment in segments for row in segment.rows], dtype=np.float64).reshape(-1, width)
    step = 2 if x_columns == "multi" else 1
    signals = [index for index in range(width) if (index % step if step == 2 else index > 0)]
    names = distinct(first.labels[index] for index in signals)
    columns = {name: rows[:, index].copy() for name, index in zip(names, signals, strict=True)}
    increments = [_number(first.tag("Delta_X", order)) for order in range(len(names))]
    rates = {name: shortest_rate(1 / dx, tolerance=1e-11) for name, dx in zip(names, increments, strict=True) if dx > 0}
    if x_columns != "no" and (len(segments) > 1 or len(rates) < len(names)):
        columns = {"time_s": rows[:, 0].copy(), **columns}
    units = {name: unit for order, name in enumerate(names) if (unit := first.tag("Y_Unit_Label", order))}
    return Table(columns=columns, rates=rates, units=units)


def _number(cell: str) -> float:
    number = Dialect("\t", ".").number(cell.replace(",", "."))
    return 0.0 if number is None or not np.isfinite(number) else number
