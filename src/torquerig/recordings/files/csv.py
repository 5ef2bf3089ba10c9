"""CSV: a header and rows, separated by comma, semicolon or tab, with decimal point or comma."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.delimited import (
    Text,
    number_columns,
    numbers,
    parsed,
    read_delimited,
    read_head,
    texts_of,
)
from torquerig.recordings.files.number_table import Table, distinct
from torquerig.recordings.files.table_pieces import Columns, TablePieces, pieces_of
from torquerig.recordings.recording import Recording

_UNNAMED = "(unnamed)"


def read_csv(path: Path) -> Table:
    """Read a CSV file; without a header it must be the bare table of time and volts (or volts alone).

    Raises
    ------
    RecordingError
        With file and line: a faulty row, a cell that is not a number, three or more columns without a header.
    """
    text = read_delimited(path)
    return Table(columns=_named(numbers(text, _names(text))))


def csv_pieces(path: Path, *, step: int = 2**25) -> TablePieces:
    """Return a CSV file in pieces of ``step`` bytes; a smaller file is read at once.

    The first piece determines separator, decimal sign and columns of words. The number of samples is known only at
    the end.
    """
    if path.stat().st_size <= step:
        return pieces_of(read_csv(path), reason="")
    head = read_head(path, step)
    every = _names(head)
    kept = [name for name in number_columns(head, every) if not name.startswith(_UNNAMED)]

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        for text in texts_of(head, step):
            columns = parsed(text, every, kept)
            yield {name: columns[name] for name in names}

    return TablePieces(names=tuple(kept), pieces=pieces)


def _names(text: Text) -> list[str]:
    # a separator at the end of each row makes a column without a name, which is ignored
    return distinct([name or _UNNAMED for name in text.names] or _bare_names(text))


def _named(columns: dict[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    return {name: values for name, values in columns.items() if not name.startswith(_UNNAMED)}


def write_csv(recording: Recording, path: Path) -> None:
    """Write time_s and the channels with comma and decimal point; the numbers read back to the same floats."""
    with path.open("wb") as file:
        write_header(file, recording)
        append_csv(file, {name: one.values for name, one in recording.channels.items()}, times=recording.time())


def write_header(file: BinaryIO, recording: Recording) -> None:
    """Write the line of names."""
    file.write((",".join(_quoted(name) for name in ("time_s", *recording.channels)) + "\n").encode())


def append_csv(file: BinaryIO, columns: Mapping[str, NDArray[np.float64]], *, times: NDArray[np.float64]) -> None:
    """Write one more block of rows that begin with their time [s]."""
    import pyarrow as pa
    from pyarrow import csv

    table = pa.table({"time_s": times, **columns})
    csv.write_csv(table, file, csv.WriteOptions(include_header=False))


def _bare_names(text: Text) -> list[str]:
    row = text.dialect.cells(text.body.partition(b"\n")[0].decode())
    if len(row) > 2 or not text.body.strip():
        problem = f"{len(row)} columns and no header" if text.body.strip() else "nothing in it"
        raise RecordingError(
            f"{text.path}:{text.first_line}: the table has {problem}; put a line with the names of the columns at the "
            "top, for example time_s,torque_V,encoder_count"
        )
    return ["time_s", "torque_V"][-len(row) :]


def _quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"' if any(sign in name for sign in ',;" \t') else name
