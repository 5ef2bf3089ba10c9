"""What is in a recording file, whether or not it can be used as it is: columns, units, rates, lengths, levels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files.plain_names import pieces_with_plain_names
from torquerig.recordings.files.reading import check_readable, entry_by_name
from torquerig.recordings.files.sidecar import ChannelEntry, Sidecar
from torquerig.recordings.files.sidecar_choice import sidecar_of
from torquerig.recordings.files.stream import open_stream, pieces_of_file, timed
from torquerig.recordings.files.table_pieces import TablePieces
from torquerig.recordings.inspection.levels import NOTHING, Levels, joined_levels, levels_of


@dataclass(frozen=True, kw_only=True)
class ColumnContents:
    """One column: what it is taken for, its sample rate [Hz] or None, its number of samples and its levels.

    ``reason`` says why it is taken for that, ``missing`` what a sidecar must add; the levels are in ``unit``, and
    ``gone`` counts the samples that are no finite number.
    """

    name: str
    quantity: str
    unit: str
    reason: str
    missing: str
    rate: float | None
    samples: int
    gone: int
    minimum: float
    mean: float
    maximum: float
    std: float

    @property
    def duration(self) -> float | None:
        """The length [s], None where the rate is not known."""
        return None if self.rate is None else self.samples / self.rate


@dataclass(frozen=True, kw_only=True)
class FileContents:
    """All columns of a file; ``problem`` is why it cannot be used as it is, empty where it can.

    Parameters
    ----------
    path : Path
    columns : tuple of ColumnContents
        Without the column of times.
    time : str or None
        The name of the column of times.
    skipped : mapping of str to str
        Columns that are not read, with the reason.
    notes : tuple of str
        What the reader understood.
    problem : str
        One sentence with the remedy, or empty.
    """

    path: Path
    columns: tuple[ColumnContents, ...]
    time: str | None
    skipped: Mapping[str, str]
    notes: tuple[str, ...]
    problem: str

    def as_dict(self) -> dict[str, Any]:
        """Return plain nested dicts, for JSON."""
        return {**asdict(self), "path": str(self.path)}

    def missing(self) -> dict[str, str]:
        """Return what a sidecar must add, by column."""
        return {one.name: one.missing for one in self.columns if one.missing}


def file_contents(path: Path) -> FileContents:
    """Return what is in a file, with its sidecar where that can be read; a whole file is never refused.

    Raises
    ------
    InputError
        A missing file, or an ending of no known format.
    RecordingError
        A file that is damaged, so that nothing in it can be read.
    """
    path = Path(path)
    check_readable(path)
    pieces = pieces_of_file(path)
    sidecar, notes, problem = _sidecar(path, pieces)
    table = pieces_with_plain_names(pieces, kept=sidecar.channels if sidecar else ())
    time = table.time_name()
    names = [name for name in table.names if name != time]
    levels = _levels(table, names)
    rate = sidecar.sample_rate if sidecar and sidecar.sample_rate else _rate_by_time(table, time, path)
    entries = {name: _entry(name, table, sidecar) for name in names}
    columns = tuple(_column(name, entries[name], levels[name], table.rates.get(name, rate)) for name in names)
    return FileContents(
        path=path,
        columns=columns,
        time=time,
        skipped=table.skipped,
        notes=(*table.notes, *notes),
        problem=problem or _problem(path),
    )


def _sidecar(path: Path, pieces: TablePieces) -> tuple[Sidecar | None, tuple[str, ...], str]:
    try:
        return *sidecar_of(path, lambda: pieces.names, embedded=pieces.sidecar), ""
    except InputError as error:
        return None, (), str(error)


def _entry(name: str, table: TablePieces, sidecar: Sidecar | None) -> ChannelEntry:
    if sidecar is not None and name in sidecar.channels:
        return sidecar.channels[name]
    return entry_by_name(name, table.units.get(name))


def _column(name: str, entry: ChannelEntry, found: tuple[Levels, int], rate: float | None) -> ColumnContents:
    levels, samples = found
    return ColumnContents(
        name=name,
        quantity=entry.quantity,
        unit=entry.unit,
        reason=entry.reason or "the sidecar",
        missing=entry.missing,
        rate=rate,
        samples=samples,
        gone=samples - levels.count,
        minimum=levels.minimum,
        mean=levels.mean,
        maximum=levels.maximum,
        std=levels.std,
    )


def _levels(table: TablePieces, names: list[str]) -> dict[str, tuple[Levels, int]]:
    """Return the levels and the number of samples of each column, in one pass where all are equally long."""
    lengths = {table.lengths.get(name) for name in names}
    passes = [names] if len(lengths) == 1 else [[name] for name in names]
    found: dict[str, tuple[Levels, int]] = dict.fromkeys(names, (NOTHING, 0))
    for wanted in passes:
        for piece in table.pieces(wanted):
            for name, values in piece.items():
                levels, samples = found[name]
                found[name] = joined_levels(levels, levels_of(values)), samples + values.size
    return found


def _rate_by_time(table: TablePieces, time: str | None, path: Path) -> float | None:
    if time is None:
        return None
    try:
        return timed(table, time, stated=None, path=path)[1].rate
    except (RecordingError, StopIteration):
        return None  # reported as the problem of the file


def _problem(path: Path) -> str:
    try:
        stream = open_stream(path)
    except (InputError, RecordingError) as error:
        return str(error)
    return "" if any(not one.truth for one in stream.entries.values()) else f"{path}: there is no measured channel"
