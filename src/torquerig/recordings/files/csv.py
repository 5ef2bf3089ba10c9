"""CSV and other text tables: any separator, preamble, units and footer; see ``text_tables``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.table_pieces import Columns, TablePieces, pieces_of
from torquerig.recordings.files.text_tables.parsing import FaultyCellError
from torquerig.recordings.files.text_tables.source import TextSource, open_text
from torquerig.recordings.files.text_tables.table import TextTable, open_table
from torquerig.recordings.names.header import split_header
from torquerig.recordings.names.time_column import time_columns
from torquerig.recordings.recording import Recording

# bytes that are parsed at a time
_STEP = 2**25


def read_csv(path: Path, only: Collection[str] = ()) -> Table:
    """Read a text table; without a line of names, one or two columns are volts, or time and volts.

    Parameters
    ----------
    path : Path
    only : collection of str
        Columns of which alone the numbers are read, with the time; a faulty cell in another one does not matter.
        All where it is empty.

    Raises
    ------
    RecordingError
        With file and line: a faulty row, a cell that is not a number, numbers with two readings.

    Source: the bare table, the reference report, Appendix A, lines 1-2 (``time``, ``volt``, 1 V = 1 N m).
    """
    return table_of(open_text(path), only)


def table_of(source: TextSource, only: Collection[str] = ()) -> Table:
    """Return the table of a text that is in a file, or in memory; as :func:`read_csv`."""
    table = open_table(source, _STEP)
    names = _among(table, only)
    parts: dict[str, list[NDArray[np.float64]]] = {name: [] for name in names}
    missing: Counter[str] = Counter()
    comments, below = 0, []
    for parsed, footer in table.pieces(names, _STEP):
        for name, values in parsed.columns.items():
            parts[name].append(values)
        missing += parsed.missing
        comments += parsed.comments
        below += [footer.note()] if footer else []
    notes = [*table.notes(), *below, table.missing_note(missing)]
    notes += [f"{comments} comment line{'s' * (comments > 1)} between the rows"] if comments else []
    return Table(
        columns={name: np.concatenate(part) if len(part) > 1 else part[0] for name, part in parts.items()},
        rates=_rates(table),
        units=table.units(),
        skipped=table.plan.skipped,
        notes=tuple(note for note in notes if note),
    )


def csv_pieces(path: Path, *, step: int = _STEP) -> TablePieces:
    """Return a text table in pieces of ``step`` bytes; a smaller file is read at once.

    The first piece determines the layout. The number of samples is known only at the end.
    """
    source = open_text(path)
    return whole_pieces(source) if path.stat().st_size <= step else source_pieces(source, step=step)


def whole_pieces(source: TextSource) -> TablePieces:
    """Return the table of a short text, read at once, so that the number of its samples is known.

    Where a cell is faulty, the columns are read when they are needed: the fault matters only in its own column.
    """
    try:
        return pieces_of(table_of(source), reason="")
    except FaultyCellError:
        return source_pieces(source)


def source_pieces(source: TextSource, *, step: int = _STEP) -> TablePieces:
    """Return the table of a text in pieces of about ``step`` bytes."""
    table = open_table(source, step)

    def pieces(names: Sequence[str]) -> Iterator[Columns]:
        for parsed, _ in table.pieces(names, step):
            yield parsed.columns

    return TablePieces(
        names=table.plan.names,
        pieces=pieces,
        rates=_rates(table),
        units=table.units(),
        skipped=table.plan.skipped,
        notes=table.notes(),
    )


def _rates(table: TextTable) -> dict[str, float]:
    rate = table.layout.rate
    return {} if rate is None else dict.fromkeys(table.plan.numbers, rate)


def _among(table: TextTable, only: Collection[str]) -> tuple[str, ...]:
    """Return the columns to read: all, or those in ``only`` (as written or without their unit) and the time."""
    names = table.plan.names
    chosen = [name for name in names if name in only or split_header(name)[0] in only]
    if len(chosen) < len(only) or not only:
        return names
    times = [one.name for one in time_columns(names, table.units())]
    # whose times they are is seen from the other columns
    return names if len(times) > 1 else tuple(name for name in names if name in chosen or name in times)


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


def _quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"' if any(sign in name for sign in ',;" \t') else name
