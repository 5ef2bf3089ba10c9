"""The rows of an LVM segment as numbers: read by columns at once, and by line where a row is short or faulty."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.number_table import distinct
from torquerig.recordings.files.text_tables.cells import Dialect

_REMARKS = "Comment"


def decoded(data: bytes) -> str:
    """Return the text: UTF-8, else the code page of Windows, in which LabVIEW writes."""
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("cp1252", errors="replace")


@dataclass(frozen=True)
class Rows:
    """The rows of a segment before their numbers are read; ``fewer`` are the stated counts of the short columns."""

    path: Path
    first_line: int
    body: bytes
    labels: list[str]
    dialect: Dialect
    fewer: Mapping[int, int]

    @property
    def width(self) -> int:
        """The number of columns of numbers."""
        return len(self.labels) - (self.labels[-1] == _REMARKS)

    def parsed(self) -> tuple[list[NDArray[np.float64]], list[NDArray[np.bool_]], bool]:
        """Return columns, places of blank cells, and whether there are remarks; RecordingError with the line."""
        body = self.body.strip(b"\n")
        if not body:
            none, nowhere = np.empty(0), np.empty(0, dtype=bool)
            return [none] * self.width, [nowhere] * self.width, False
        lines = body.split(b"\n", 2)[:2]
        cells = lines[-1].count(self.dialect.separator.encode()) + 1
        found = self._numbers(body, cells) if cells >= self.width else None
        if found is None:
            found = self._numbers("\n".join(self._evened(exact=False)).encode(), len(self.labels))
        if found is None:
            found = self._numbers("\n".join(self._evened(exact=True)).encode(), len(self.labels))
        if found is None:
            raise RecordingError(
                f"{self.path}:{self.first_line}: the rows from here on are no numbers; save the file again in LabVIEW"
            )
        return found

    def _numbers(
        self, body: bytes, cells: int
    ) -> tuple[list[NDArray[np.float64]], list[NDArray[np.bool_]], bool] | None:
        """Return the columns of rows that all have ``cells`` cells, or None."""
        import pyarrow as pa
        from pyarrow import compute, csv

        names = [*distinct(self.labels[: self.width]), *(f"\0{index}" for index in range(self.width, cells))]
        kinds = {name: pa.float64() if index < self.width else pa.string() for index, name in enumerate(names)}
        try:
            table = csv.read_csv(
                pa.BufferReader(body),
                read_options=csv.ReadOptions(column_names=names),
                parse_options=csv.ParseOptions(delimiter=self.dialect.separator, quote_char=False),
                convert_options=csv.ConvertOptions(
                    column_types=kinds, null_values=[""], decimal_point=self.dialect.decimal
                ),
            )
        except (pa.ArrowInvalid, ValueError):
            return None
        beyond = [bool(compute.any(compute.not_equal(table[name], "")).as_py()) for name in names[self.width :]]
        if any(beyond[len(self.labels) - self.width :]):
            return None
        blank = [np.asarray(compute.is_null(table[name]).to_numpy()) for name in names[: self.width]]
        columns = [
            np.asarray(compute.fill_null(table[name], float("nan")).to_numpy(), dtype=np.float64)
            for name in names[: self.width]
        ]
        return columns, blank, any(beyond)

    def _evened(self, *, exact: bool) -> Iterator[str]:
        """Yield the rows with equally many cells: short columns end in blank cells, a remark may be missing.

        With ``exact`` each cell is read, so that the first that is no number is found with its line.
        """
        sign, filled = self.dialect.separator, 0
        for index, line in enumerate(decoded(self.body).split("\n")):
            if not line.strip():
                continue
            if exact or line.count(sign) != len(self.labels) - 1:
                place = f"{self.path}:{self.first_line + index}"
                cells = line.split(sign)
                self._check_width(place, cells, filled)
                cells = (cells + [""] * len(self.labels))[: len(self.labels)]
                yield sign.join(self._read(place, cells) if exact else cells)
            else:
                yield line
            filled += 1

    def _read(self, place: str, cells: list[str]) -> list[str]:
        """Return the cells with their numbers in the plainest form."""
        for index, cell in enumerate(cells[: self.width]):
            number = self.dialect.number(cell.strip())
            if number is None:
                raise RecordingError(
                    f"{place}: {self.labels[index]}: {cell!r} is no number; correct the cell or delete the row"
                )
            cells[index] = repr(number).replace(".", self.dialect.decimal) if cell.strip() else ""
        return cells

    def _check_width(self, place: str, cells: list[str], row: int) -> None:
        missing = range(len(cells), self.width)
        if any(column not in self.fewer or self.fewer[column] > row for column in missing) or any(
            cell.strip() for cell in cells[len(self.labels) :]
        ):
            raise RecordingError(
                f"{place}: the row has {len(cells)} cells and the table {self.width} columns; complete or delete the "
                "row"
            )
