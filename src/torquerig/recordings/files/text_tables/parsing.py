"""Rows of text to columns of numbers: at once where all rows are sound, else line by line, with the faulty line."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.text_tables.block import NUMBER, WORDS, family_of
from torquerig.recordings.files.text_tables.cells import MISSING, ONE_READING, Dialect, form_of, two_readings
from torquerig.recordings.files.text_tables.columns import StampColumn
from torquerig.recordings.files.text_tables.layout import Layout
from torquerig.recordings.files.text_tables.lines import is_comment
from torquerig.recordings.files.text_tables.source import decoded
from torquerig.recordings.files.text_tables.stamps import Stamps
from torquerig.recordings.files.text_tables.written_dates import with_signs
from torquerig.recordings.names.time_column import time_column

_COMMENT = re.compile(rb'(?m)^[ \t"]*(?:#|%|//)[^\n]*(?:\n|\Z)')
_PLUS = re.compile(rb"(?<![0-9eE.,+\-])\+(?=[0-9.,])")
_GROUPED = {
    sign: re.compile(rb"(?<![0-9.,])[+-]?[1-9][0-9]{0,2}(?:" + re.escape(sign.encode()) + rb"[0-9]{3})+(?![0-9])")
    for sign in ",."
}
# a cell between semicolons that may be 1234 or 1.234
_ONE_GROUP_CELL = re.compile(rb"(?m)(?:^|;)[ \t\"]*[+-]?[1-9][0-9]{0,2}\.[0-9]{3}[ \t\r\"]*(?:;|$)")
_ARROW_MISSING = sorted({form for word in MISSING for form in (word, word.upper(), word.capitalize())} | {"NaN"})


class FaultyCellError(RecordingError):
    """A cell that is no number or no time stamp; the other columns can be read."""


@dataclass(frozen=True, kw_only=True)
class Parsed:
    """The columns of some rows, the number of missing cells of each column, and of comment lines between the rows."""

    columns: dict[str, NDArray[np.float64]]
    missing: Counter[str] = field(default_factory=Counter)
    comments: int = 0


class RowParser:
    """Parses the rows of one table, piece by piece.

    Parameters
    ----------
    layout : Layout
    wanted : sequence of str
        The columns of numbers to read, and the name of the column of time stamps.
    stamps : StampColumn or None
    """

    def __init__(self, layout: Layout, wanted: Sequence[str], stamps: StampColumn | None) -> None:
        self._layout = layout
        self._stamps = stamps if stamps is not None and stamps.name in wanted else None
        self._numbers = [name for name in wanted if self._stamps is None or name != self._stamps.name]
        self._order = list(wanted)
        forms = self._stamps.forms if self._stamps else ()
        self._converters = [Stamps(form, with_date=len(forms) > 1) for form in forms]

    def parse(self, body: bytes, line: int) -> Parsed:
        """Return the columns of complete lines, the first of which has the number ``line`` in the file.

        Raises
        ------
        RecordingError
            With the line and the remedy, for a row of more or fewer cells, or a cell that is not a number.
        """
        if not body.strip():
            return Parsed(columns={name: np.empty(0) for name in self._order})
        if not self._layout.decimal and self._layout.dialect.separator == ";" and _ONE_GROUP_CELL.search(body):
            self._refuse_late_groups(body, line)
        quick = self._at_once(body)
        if quick is not None:
            return quick
        comments = len(_COMMENT.findall(body))
        cleaned = _PLUS.sub(b"", _COMMENT.sub(b"", body) if comments else body)
        if len(cleaned) < len(body) and cleaned.strip():
            again = self._at_once(cleaned)
            if again is not None:
                return Parsed(columns=again.columns, missing=again.missing, comments=comments)
        return self._by_line(body, line)

    def _refuse_late_groups(self, body: bytes, first: int) -> None:
        """Refuse 1.234 below whole numbers only, unless another number has a point that separates no thousands."""
        places = [self._layout.names.index(name) for name in self._numbers]
        found = None
        for number, text in enumerate(decoded(body).split("\n"), first):
            cells = self._layout.dialect.cells(text) if "." in text else []
            forms = {form_of(cells[place]): cells[place] for place in places if place < len(cells)}
            if "point" in forms:
                return
            if found is None and "one group by point" in forms:
                found = number, forms["one group by point"]
        if found is not None:
            raise RecordingError(
                f"{self._layout.path}:{found[0]}: {found[1]!r} may be {two_readings(found[1])}; {ONE_READING}"
            )

    def _at_once(self, body: bytes) -> Parsed | None:
        import pyarrow as pa
        from pyarrow import csv

        layout = self._layout
        texts = list(self._stamps.columns) if self._stamps else []
        kept = [*self._numbers, *texts]
        sign = layout.dialect.thousands
        others = [name for name in self._numbers if name in layout.other_decimal]
        if not kept or (sign and (texts or others or sign == layout.dialect.separator)):
            return None
        if others and layout.dialect.decimal == ".":
            return None  # a decimal comma in one column alone is read line by line
        body = _GROUPED[sign].sub(lambda match: match[0].replace(sign.encode(), b""), body) if sign else body
        try:
            table = csv.read_csv(
                pa.BufferReader(_single_blanks(body) if layout.dialect.separator == " " else body),
                read_options=csv.ReadOptions(column_names=list(layout.names)),
                parse_options=csv.ParseOptions(delimiter=layout.dialect.separator),
                convert_options=csv.ConvertOptions(
                    column_types=dict.fromkeys(self._numbers, pa.float64())
                    | dict.fromkeys([*texts, *others], pa.string()),
                    include_columns=kept,
                    decimal_point=layout.dialect.decimal,
                    null_values=_ARROW_MISSING,
                ),
            )
            columns = {
                name: np.asarray(table[name].cast(pa.float64()).to_numpy(), dtype=np.float64) for name in self._numbers
            }
            if self._stamps:
                columns[self._stamps.name] = self._times([table[name].to_pylist() for name in texts])
        except (pa.ArrowInvalid, ValueError):
            return None
        missing = Counter({name: table[name].null_count for name in self._numbers if table[name].null_count})
        return Parsed(columns={name: columns[name] for name in self._order}, missing=missing)

    def _times(self, cells: Sequence[Sequence[str]]) -> NDArray[np.float64]:
        """Return the sum of what the columns of stamps hold: date and time of day, or both in one."""
        times = [
            one.seconds([with_signs(cell.strip()) for cell in column])
            for one, column in zip(self._converters, cells, strict=True)
        ]
        return times[0] if len(times) == 1 else times[0] + times[1]

    def _by_line(self, body: bytes, first: int) -> Parsed:
        layout, missing, comments = self._layout, Counter[str](), 0
        places = {name: layout.names.index(name) for name in self._numbers}
        texts = [layout.names.index(name) for name in self._stamps.columns] if self._stamps else []
        needed = max([*places.values(), *texts], default=-1) + 1
        values: dict[str, list[float]] = {name: [] for name in self._numbers}
        stamps: list[list[str]] = [[] for _ in texts]
        lines: list[int] = []
        for number, text in enumerate(decoded(body).split("\n"), first):
            if not text.strip(" \t\r\0"):
                continue
            if is_comment(text):
                comments += 1
                continue
            cells = self._row(text, number, needed)
            self._refuse_names(cells, places.values(), number)
            for name, place in places.items():
                values[name].append(self._number(cells[place], name, number, missing))
            for column, place in zip(stamps, texts, strict=True):
                column.append(cells[place])
            lines.append(number)
        columns = {name: np.array(numbers, dtype=np.float64) for name, numbers in values.items()}
        if self._stamps:
            columns[self._stamps.name] = self._times_of_lines(stamps, lines)
        return Parsed(columns={name: columns[name] for name in self._order}, missing=missing, comments=comments)

    def _row(self, text: str, number: int, needed: int) -> list[str]:
        """Return the cells of a row; cells behind the last one that is read may be missing."""
        width = len(self._layout.names)
        cells = self._layout.dialect.cells(text)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if needed <= len(cells) <= width:
            return cells
        whole = self._layout.dialect.separator == "," and len(cells) > 1
        commas = whole and all(cell.lstrip("+-").isdigit() for cell in cells)
        hint = " (if the commas are decimal signs, separate the cells by semicolons)" if commas else ""
        raise RecordingError(
            f"{self._layout.path}:{number}: the row has {len(cells)} cell{'s' * (len(cells) != 1)} and the table "
            f"{width} columns; complete or delete the row{hint}"
        )

    def _refuse_names(self, cells: Sequence[str], places: Collection[int], line: int) -> None:
        """Refuse a row of words among the numbers: the names of another table."""
        numbers = [cells[place] for place in places]
        if numbers and all(family_of(cell, "") == WORDS and not any(map(str.isdigit, cell)) for cell in numbers):
            raise RecordingError(
                f"{self._layout.path}:{line}: the row holds words in place of numbers, as at the start of another "
                "table; split the file there"
            )

    def _number(self, cell: str, name: str, line: int, missing: Counter[str]) -> float:
        dialect = self._layout.dialect
        if name in self._layout.other_decimal:
            dialect = Dialect(dialect.separator, "." if dialect.decimal == "," else ",")
        found = dialect.number(cell)
        if found is None and any(sign.isdigit() for sign in cell):
            both = two_readings(cell)
            two = f" (it may be {both})" if both else ""
            time = time_column(self._layout.of_family(NUMBER), self._layout.units)
            # the times are read whatever the sidecar names
            others = "" if time is not None and time.name == name else ", or name the columns to be read in a sidecar"
            raise FaultyCellError(
                f"{self._layout.path}:{line}: {name}: {cell!r} is no number{two}; correct the cell or delete the "
                f"row{others}"
            )
        if found is None or found != found:  # noqa: PLR0124 (not a number)
            missing[name] += 1
        return float("nan") if found is None else found

    def _times_of_lines(self, stamps: Sequence[Sequence[str]], lines: Sequence[int]) -> NDArray[np.float64]:
        try:
            return self._times(stamps)
        except ValueError as error:
            number, cell = error.args
            columns = self._stamps.columns if self._stamps else ()
            raise FaultyCellError(
                f"{self._layout.path}:{lines[number]}: {columns[-1]}: {cell!r} is no time stamp as those above it; "
                "correct the cell or delete the row"
            ) from error


def _single_blanks(data: bytes) -> bytes:
    return re.sub(rb"[ \t]+", b" ", re.sub(rb"(?m)^[ \t]+|[ \t\r]+$", b"", data))
