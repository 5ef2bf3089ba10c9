"""A recording that is read block by block, so that memory does not grow with its length."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.checks import check_counts
from torquerig.recordings.files.csv import csv_pieces
from torquerig.recordings.files.gz import TEXT_ENDINGS, gz_pieces
from torquerig.recordings.files.hdf5 import hdf5_pieces
from torquerig.recordings.files.long_format import refuse_long_format
from torquerig.recordings.files.lvm import read_lvm
from torquerig.recordings.files.mat import mat_pieces
from torquerig.recordings.files.parquet import parquet_pieces
from torquerig.recordings.files.plain_names import pieces_with_plain_names
from torquerig.recordings.files.reading import channel_entries, check_readable, readers
from torquerig.recordings.files.sidecar import ChannelEntry
from torquerig.recordings.files.sidecar_choice import sidecar_of
from torquerig.recordings.files.starts import refuse_late_starts, remedy_for_lengths
from torquerig.recordings.files.table_pieces import TablePieces, pieces_of
from torquerig.recordings.files.tdms_pieces import tdms_pieces
from torquerig.recordings.files.time_unit import in_unit, unit_evidence
from torquerig.recordings.files.timebase import agreed_rate, refuse_problem, refuse_two_rates, stated_rate
from torquerig.recordings.files.timing import Timing, timing_of
from torquerig.recordings.files.wav import wav_pieces
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run


def _lvm_pieces(path: Path) -> TablePieces:
    return pieces_of(read_lvm(path), reason="an LVM file is text in segments and read whole; save it as TDMS")


STREAMS: Mapping[str, Callable[[Path], TablePieces]] = {
    ".parquet": parquet_pieces,
    **dict.fromkeys(TEXT_ENDINGS, csv_pieces),
    ".gz": gz_pieces,
    ".mat": mat_pieces,
    ".tdms": tdms_pieces,
    ".lvm": _lvm_pieces,
    ".wav": wav_pieces,
    **dict.fromkeys((".h5", ".hdf5", ".hdf"), hdf5_pieces),
}


@dataclass(frozen=True, kw_only=True)
class RecordingStream:
    """A recording on disk: its description without the samples.

    Parameters
    ----------
    path : Path
    sample_rate : float
        [Hz].
    samples : int or None
        Of every channel; None where it is known only after reading to the end (CSV).
    entries : mapping of str to ChannelEntry
        Quantity, unit and scale of each channel.
    run, origin
        As in :class:`Recording`.
    table : TablePieces
        The source of the samples; ``table.read_whole`` is the reason where the file could not be read in pieces.
    time_scatter : float
        How far coarse or late times deviate from even steps [s], see :class:`Timing`.
    """

    path: Path
    sample_rate: float
    samples: int | None
    entries: Mapping[str, ChannelEntry]
    table: TablePieces
    run: Run = field(default_factory=Run)
    origin: Mapping[str, Any] = field(default_factory=dict)
    time_scatter: float = 0.0

    def of(self, columns: Mapping[str, NDArray[np.float64]]) -> Recording:
        """Return a recording with these samples of each channel."""
        channels = {name: entry.channel(columns[name]) for name, entry in self.entries.items()}
        return Recording(
            sample_rate=self.sample_rate, channels=channels, run=self.run, origin=self.origin, name=self.path.name,
            path=self.path,
        )  # fmt: skip

    def comparing(self, name: str) -> RecordingStream:
        """Return this recording with the channel ``name`` as the measured torque; errors as ``Recording.comparing``."""
        chosen = self.of(dict.fromkeys(self.entries, np.empty(0))).comparing(name).channels
        entries = {
            key: replace(entry, quantity=chosen[key].quantity, role=chosen[key].role)
            for key, entry in self.entries.items()
        }
        return replace(self, entries=entries)

    def columns(self) -> Iterator[Mapping[str, NDArray[np.float64]]]:
        """Yield the samples of the channels, and of the time column where there is one, piece by piece."""
        time = self.table.time_name()
        yield from self.table.pieces([*self.entries, *([time] if time and time not in self.entries else [])])


def open_stream(path: Path) -> RecordingStream:
    """Return the description of a recording, with its sidecar where there is one; samples are read when needed.

    Raises
    ------
    InputError, RecordingError
        As :func:`read_recording`: a damaged file, wrong columns, unequal lengths, missing or contradictory rates.
        Samples that are not numbers and jumps of time are found only in the blocks.
    """
    path = Path(path)
    check_readable(path)
    pieces = pieces_of_file(path)
    sidecar, notes = sidecar_of(path, lambda: pieces.names, embedded=pieces.sidecar)
    table = pieces_with_plain_names(pieces, kept=sidecar.channels if sidecar else ())
    table = replace(table, notes=(*table.notes, *notes))
    entries = channel_entries(table.names, table.units, sidecar, path)
    time = table.time_name()
    refuse_two_rates(table.rates, entries, where=str(path))
    refuse_late_starts(table.starts, table.rates, entries, where=str(path))
    lengths = {name: table.lengths[name] for name in (*([time] if time else []), *entries) if name in table.lengths}
    remedy = remedy_for_lengths(table.rates, lengths, where=str(path))
    samples = check_counts(lengths, str(path), remedy=remedy) if lengths else None
    timing = None
    if time is not None:
        table, timing = timed(table, time, stated=stated_rate(table.rates, entries, sidecar=sidecar), path=path)
    rate = agreed_rate(table.rates, entries, timing=timing, time_name=time, sidecar=sidecar, where=str(path))
    return RecordingStream(
        path=path,
        sample_rate=rate,
        samples=samples,
        entries=entries,
        table=table,
        run=sidecar.run if sidecar else Run(),
        origin=sidecar.origin if sidecar else {},
        time_scatter=timing.scatter if timing else 0.0,
    )


def timed(table: TablePieces, time: str, *, stated: float | None, path: Path) -> tuple[TablePieces, Timing]:
    """Return the table with its times in seconds and a note about them, and the sampling that the first ones show."""
    times = _first_times(table, time, path)
    if np.any(np.diff(times) <= 0):
        others = [name for name in table.names if name != time]
        first = next(iter(table.pieces([time, *others])))
        signals = {name: first[name] for name in others}
        refuse_long_format(first[time], signals, skipped=table.skipped, name=time, where=str(path))
    timing = timing_of(times, name=time, stated=stated)
    if not timing.rate > 0:
        refuse_problem(timing, name=time, where=str(path))
    notes = [*table.notes, *([timing.note] if timing.note else [])]
    if table.time_has_unit:
        return replace(table, notes=tuple(notes)), timing
    seconds, note = unit_evidence(
        timing, first=float(times[0]), samples=times.size, stated=stated, name=time, where=str(path)
    )
    if seconds == 1.0:
        return replace(table, notes=tuple(notes)), timing

    notes = [one for one in notes if not one.endswith("states no unit and is read as seconds")]

    def pieces(names: Sequence[str]) -> Iterator[Mapping[str, NDArray[np.float64]]]:
        for piece in table.pieces(names):
            yield {name: values * seconds if name == time else values for name, values in piece.items()}

    return replace(table, pieces=pieces, notes=(*notes, note)), in_unit(timing, seconds)


def pieces_of_file(path: Path) -> TablePieces:
    """Return the table of a file in pieces; a format that comes with another package is read whole."""
    ending = path.suffix.lower()
    if ending in STREAMS:
        return STREAMS[ending](path)
    return pieces_of(
        readers()[ending](path), reason=f"the reader of {ending} files reads them whole; save it as Parquet"
    )


def _first_times(table: TablePieces, time: str, path: Path) -> NDArray[np.float64]:
    times = next(iter(table.pieces([time])), {time: np.empty(0)})[time]
    if times.size < 2:
        raise RecordingError(f"{path}: the recording has fewer than 2 samples; record it again")
    return times
