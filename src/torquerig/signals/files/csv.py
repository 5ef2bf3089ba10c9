"""CSV: a header and rows, separated by comma, semicolon or tab, with decimal point or comma."""

from __future__ import annotations

from pathlib import Path

from torquerig.errors import RecordingError
from torquerig.signals.files.delimited import Text, numbers, read_delimited
from torquerig.signals.files.table import Table, distinct
from torquerig.signals.recording import Recording

_UNNAMED = "(unnamed)"


def read_csv(path: Path) -> Table:
    """Read a CSV file; without a header it must be the bare table of time and volts (or volts alone).

    Raises
    ------
    RecordingError
        With file and line: a broken row, a cell that is no number, three or more columns without a header.
    """
    text = read_delimited(path)
    # a separator at the end of each row makes a column without a name, which is left out
    names = distinct([name or _UNNAMED for name in text.names] or _bare_names(text))
    columns = numbers(text, names)
    return Table(columns={name: values for name, values in columns.items() if not name.startswith(_UNNAMED)})


def write_csv(recording: Recording, path: Path) -> None:
    """Write time_s and the channels with comma and decimal point; the numbers read back to the same floats."""
    import pyarrow as pa
    from pyarrow import csv

    columns = {"time_s": recording.time(), **{name: one.values for name, one in recording.channels.items()}}
    table = pa.table(dict(columns))
    header = ",".join(_quoted(name) for name in columns) + "\n"
    with path.open("wb") as file:
        file.write(header.encode())
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
