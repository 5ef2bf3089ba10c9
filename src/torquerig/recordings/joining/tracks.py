"""Columns with a rate and a start of their own, from one file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.gaps import gaps_in
from torquerig.recordings.files.plain_names import pieces_with_plain_names
from torquerig.recordings.files.reading import channel_entries, check_readable
from torquerig.recordings.files.sidecar import ChannelEntry, sidecar_path
from torquerig.recordings.files.sidecar_choice import sidecar_of
from torquerig.recordings.files.stream import pieces_of_file
from torquerig.recordings.files.timebase import usual_rate
from torquerig.recordings.files.timing import timing_of
from torquerig.recordings.run import Run


@dataclass(frozen=True, kw_only=True)
class Track:
    """One column: its samples, its rate [Hz], the time of its first sample [s] on the clock of its file."""

    name: str
    values: NDArray[np.float64]
    rate: float
    start: float
    entry: ChannelEntry


@dataclass(frozen=True, kw_only=True)
class Tracks:
    """The columns of one file; ``has_clock`` says whether the file states their starts or has a column of times."""

    path: Path
    tracks: Mapping[str, Track]
    run: Run
    has_clock: bool
    notes: tuple[str, ...] = ()


def tracks_of(path: Path) -> Tracks:
    """Return the columns of a file, each with its own rate; unevenly stamped ones on the even grid of their rate.

    Late stamps and gaps of at most one second are bridged by straight lines; ``notes`` says where.

    Raises
    ------
    InputError, RecordingError
        A file or sidecar that cannot be read, a column without a rate, samples that are not numbers, a longer gap.
    """
    path = Path(path)
    check_readable(path)
    written = pieces_of_file(path)
    sidecar, notes = sidecar_of(path, lambda: written.names, embedded=written.sidecar)
    table = pieces_with_plain_names(written, kept=sidecar.channels if sidecar else ())
    entries = channel_entries(table.names, table.units, sidecar, path)
    time = table.time_name()
    lengths = {table.lengths.get(name) for name in entries}
    wanted = [*entries, *([time] if time else [])]
    passes = [wanted] if len(lengths) == 1 else [[name] for name in wanted]
    columns: dict[str, NDArray[np.float64]] = {}
    for names in passes:
        pieces = list(table.pieces(names))
        columns |= {name: np.concatenate([piece[name] for piece in pieces]) for name in names}
    times = columns.pop(time) if time else None
    stated = sidecar.sample_rate if sidecar else None
    tracks: dict[str, Track] = {}
    for name, entry in entries.items():
        rate = stated or table.rates.get(name)
        values, start = columns[name], table.starts.get(name, 0.0)
        _check_finite(name, values, path)
        if times is not None and times.size == values.size:
            start = float(times[0])
            if rate is None:
                timing = timing_of(times, name=str(time))
                rate = timing.rate if timing.rate > 0 else usual_rate(times, name=str(time), where=str(path))
                # coarse and late stamps are those of even samples
                bridged: tuple[str, ...] = (f"{path.name}: {timing.note}",) if timing.note else ()
                if timing.problem:
                    values, bridged = _evenly(values, times, rate, name=str(time), path=path)
                notes = notes if bridged and bridged[0] in notes else (*notes, *bridged)
        if rate is None:
            raise RecordingError(
                f"{path}: the rate of {name} is not stated; write it into {sidecar_path(path).name} as "
                "sample_rate_Hz: NUMBER"
            )
        tracks[name] = Track(name=name, values=values, rate=rate, start=start, entry=entry)
    run = sidecar.run if sidecar else Run()
    return Tracks(path=path, tracks=tracks, run=run, has_clock=times is not None or bool(table.starts), notes=notes)


def _evenly(
    values: NDArray[np.float64], times: NDArray[np.float64], rate: float, *, name: str, path: Path
) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """Return the samples on an even grid where the stamps have gaps, and what was bridged."""
    gaps = gaps_in(times, rate)
    if not gaps:
        return values, ()
    worst = max(gaps, key=lambda gap: abs(gap.step))
    if not np.all(np.diff(times) > 0):
        back = next(gap for gap in gaps if gap.step <= 0)
        raise RecordingError(
            f"{path}: {name} goes back by {-back.step:.6g} s after sample {back.sample}; cut the file there and join "
            "the parts"
        )
    if worst.step > _LONGEST_GAP:
        raise RecordingError(
            f"{path}: {name} jumps by {worst.step:.6g} s after sample {worst.sample} ({worst.time:.6g} s), too long "
            f"to bridge (at most {_LONGEST_GAP:g} s); cut the file there"
        )
    grid = times[0] + np.arange(int((times[-1] - times[0]) * rate + 0.5) + 1) / rate
    note = f"{path.name}: {len(gaps)} steps of {name} are not one sample long (the longest {worst.step:.6g} s after sample {worst.sample}); bridged by straight lines"  # noqa: E501
    return np.interp(grid, times, values), (note,)


_LONGEST_GAP = 1.0  # [s]; what lies in a longer gap no straight line can stand for


def _check_finite(name: str, values: NDArray[np.float64], path: Path) -> None:
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        raise RecordingError(
            f"{path}: {name} has {bad.size} samples that are no finite number, the first at sample {bad[0]}; cut the "
            "file to a span without them"
        )
