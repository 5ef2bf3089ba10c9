"""Columns with a rate and a start of their own, from one file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.files.gaps import FEWEST_SAMPLES, gaps_in
from torquerig.recordings.files.long_format import refuse_long_format
from torquerig.recordings.files.plain_names import pieces_with_plain_names
from torquerig.recordings.files.rate_changes import Stretch, stretches_of_rates
from torquerig.recordings.files.reading import channel_entries, check_readable
from torquerig.recordings.files.sidecar import ChannelEntry, Sidecar, sidecar_path
from torquerig.recordings.files.sidecar_choice import sidecar_of
from torquerig.recordings.files.stream import pieces_of_file
from torquerig.recordings.files.table_pieces import TablePieces
from torquerig.recordings.files.time_unit import unit_evidence
from torquerig.recordings.files.timebase import agreed_rate, usual_rate
from torquerig.recordings.files.timing import timing_of
from torquerig.recordings.joining.resampling import resampled
from torquerig.recordings.joining.track import Track
from torquerig.recordings.run import Run

LONGEST_GAP = 1.0
"""Longest gap that is bridged unless another is stated [s]: in a longer one the rig may have moved."""
_SHORTEST = 4  # fewest samples of a stretch that is a recording


@dataclass(frozen=True, kw_only=True)
class Tracks:
    """The columns of one file; ``has_clock`` says whether the file states their starts or has a column of times."""

    path: Path
    tracks: Mapping[str, Track]
    run: Run
    has_clock: bool
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class _Columns:
    """What a file holds: its columns, their times [s] where it has some, and what is stated of both."""

    path: Path
    values: Mapping[str, NDArray[np.float64]]
    times: NDArray[np.float64] | None
    time: str | None
    table: TablePieces
    sidecar: Sidecar | None
    entries: Mapping[str, ChannelEntry]
    notes: tuple[str, ...]


def tracks_of(path: Path, *, longest_gap: float = LONGEST_GAP) -> Tracks:
    """Return the columns of a file, each with its own rate; unevenly stamped ones on the even grid of their rate.

    Late stamps and gaps of at most ``longest_gap`` [s] are bridged by straight lines; ``notes`` says where.

    Raises
    ------
    InputError, RecordingError
        A file or sidecar that cannot be read, a column without a rate, samples that are not numbers, a longer gap.
    """
    return _tracks(_columns(path), longest_gap=longest_gap)


def split_tracks(path: Path, *, longest_gap: float = LONGEST_GAP) -> tuple[Tracks, ...]:
    """Return the stretches of a file between its pauses, each with its columns as :func:`tracks_of` returns them.

    A pause is a step of time longer than ``longest_gap`` [s] and than ten usual steps. A stretch of fewer than four
    samples is left out; the notes of the first stretch count them.

    Raises
    ------
    InputError, RecordingError
        As :func:`tracks_of`, and for a file without times, or whose columns differ in length.
    """
    whole = _columns(path)
    times = whole.times
    if times is None or any(one.size != times.size for one in whole.values.values()):
        raise RecordingError(f"{path}: it has no column of times for all samples, so that no pause is known; leave "
                             "--split out")  # fmt: skip
    _refuse_falling(times, str(whole.time), whole.path)
    steps = np.diff(times)
    pauses = np.flatnonzero(steps > max(longest_gap, FEWEST_SAMPLES * float(np.median(steps)))) + 1
    edges = [0, *pauses.tolist(), times.size]
    parts = [slice(first, last) for first, last in pairwise(edges) if last - first >= _SHORTEST]
    if not parts:
        raise RecordingError(f"{path}: no stretch between two pauses has {_SHORTEST} samples; fill the pauses with "
                             "--bridge TIME instead")  # fmt: skip
    left_out = len(edges) - 1 - len(parts)
    said = (f"{whole.path.name}: {left_out} stretches of fewer than {_SHORTEST} samples are left out",) * bool(left_out)
    found: list[Tracks] = []
    for part in parts:
        cut = replace(
            whole, times=times[part], values={name: one[part] for name, one in whole.values.items()},
            notes=whole.notes if found else (*whole.notes, *said),
        )  # fmt: skip
        found.append(_tracks(cut, longest_gap=longest_gap))
    return tuple(found)


def _columns(path: Path) -> _Columns:
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
    if times is not None:
        refuse_long_format(times, columns, skipped=table.skipped, name=str(time), where=str(path))
        times = _in_seconds(times, table, name=str(time), stated=stated, path=path)
    return _Columns(
        path=path, values=columns, times=times, time=time, table=table, sidecar=sidecar, entries=entries, notes=notes
    )


def _tracks(given: _Columns, *, longest_gap: float) -> Tracks:
    path, columns, times, table, sidecar = given.path, given.values, given.times, given.table, given.sidecar
    time, notes, stated = given.time, given.notes, given.sidecar.sample_rate if given.sidecar else None
    tracks: dict[str, Track] = {}
    for name, entry in given.entries.items():
        rate = stated or table.rates.get(name)
        values, start = columns[name], table.starts.get(name, 0.0)
        _check_finite(name, values, path)
        if times is not None and times.size == values.size:
            start = float(times[0])
            timing = timing_of(times, name=str(time), stated=rate)
            if rate is None:
                rate = timing.rate if timing.rate > 0 else usual_rate(times, name=str(time), where=str(path))
            elif not timing.problem:
                agreed_rate(table.rates, [name], timing=timing, time_name=time, sidecar=sidecar, where=str(path))
            # coarse and late stamps are those of even samples
            bridged: tuple[str, ...] = (f"{path.name}: {timing.note}",) if timing.note else ()
            if timing.problem:
                raw = Track(name=name, values=values, rate=rate, start=start, entry=entry)
                values, bridged = _evenly(raw, times, name=str(time), path=path, longest_gap=longest_gap)
            notes = notes if bridged and bridged[0] in notes else (*notes, *bridged)
        if rate is None:
            raise RecordingError(
                f"{path}: the rate of {name} is not stated; write it into {sidecar_path(path).name} as "
                "sample_rate_Hz: NUMBER"
            )
        tracks[name] = Track(name=name, values=values, rate=rate, start=start, entry=entry)
    run = sidecar.run if sidecar else Run()
    return Tracks(path=path, tracks=tracks, run=run, has_clock=times is not None or bool(table.starts), notes=notes)


def _in_seconds(
    times: NDArray[np.float64], table: TablePieces, *, name: str, stated: float | None, path: Path
) -> NDArray[np.float64]:
    """Return times whose unit the file may not state in seconds."""
    timing = timing_of(times, name=name, stated=stated)
    if table.time_has_unit or not timing.rate > 0:
        return times
    seconds, _ = unit_evidence(
        timing, first=float(times[0]), samples=times.size, stated=stated, name=name, where=str(path)
    )
    return times * seconds


def _evenly(
    track: Track, times: NDArray[np.float64], *, name: str, path: Path, longest_gap: float
) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """Return the samples of uneven ``times`` [s], shape (samples,), on an even grid, and what was done."""
    _refuse_falling(times, name, path)
    stretches = stretches_of_rates(times)
    gaps = gaps_in(times, track.rate)
    worst = max(gaps, key=lambda gap: abs(gap.step), default=None)
    longest = max((1 / one.rate for one in stretches), default=0.0)
    if worst is not None and worst.step > max(longest_gap, 1.5 * longest):
        raise RecordingError(
            f"{path}: {name} jumps by {worst.step:.6g} s after sample {worst.sample} ({worst.time:.6g} s), too long "
            f"to bridge (at most {longest_gap:g} s); where nothing moves in the pauses, fill them with "
            f"--bridge '{_rounded_up(worst.step):g} s', else write each stretch as a recording with --split (pauses "
            f"of {FEWEST_SAMPLES} usual steps and more)"
        )
    grid = times[0] + np.arange(int((times[-1] - times[0]) * track.rate + 0.5) + 1) / track.rate
    if stretches:
        named = ", ".join(f"{one.rate:.6g} Hz from sample {one.first} on" for one in stretches)
        note = f"{path.name}: {name} has several rates ({named}), and all samples are brought to {track.rate:.6g} Hz"
        return _of_stretches(track, times, stretches, grid), (note,)
    if worst is None:
        note = f"{path.name}: the steps of {name} are uneven; the samples between its times are on straight lines"
    else:
        note = (
            f"{path.name}: {len(gaps)} steps of {name} are not one sample long (the longest {worst.step:.6g} s after "
            f"sample {worst.sample}); bridged by straight lines"
        )
    return np.interp(grid, times, track.values), (note,)


def _refuse_falling(times: NDArray[np.float64], name: str, path: Path) -> None:
    steps = np.diff(times)
    if np.all(steps > 0):
        return
    sample = int(np.argmin(steps > 0))
    if not np.isfinite(steps[sample]):
        raise RecordingError(
            f"{path}: {name} has no time for sample {sample + bool(np.isfinite(times[sample]))}; delete the row, or "
            "write the time"
        )
    raise RecordingError(
        f"{path}: {name} goes back by {-steps[sample]:.6g} s after sample {sample}; cut the file there and join "
        "the parts"
    )


def _of_stretches(
    track: Track, times: NDArray[np.float64], stretches: tuple[Stretch, ...], grid: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the samples at the times ``grid`` [s], each stretch brought to the rate of the track by itself."""
    values = np.interp(grid, times, track.values)
    for one in stretches:
        part = replace(track, values=track.values[one.first : one.last + 1], rate=one.rate, start=times[one.first])
        first, last = np.searchsorted(grid, [times[one.first] - _ROUNDING, times[one.last] + _ROUNDING])
        values[first:last] = resampled(part, rate=track.rate, start=float(grid[first]), samples=int(last - first))
    return values


_ROUNDING = 1e-9  # [s]; of a time on the grid


def _rounded_up(seconds: float) -> float:
    """Return the time with two digits, not less than ``seconds``."""
    step = 10.0 ** (np.floor(np.log10(seconds)) - 1)
    return float(np.ceil(seconds / step) * step)


def _check_finite(name: str, values: NDArray[np.float64], path: Path) -> None:
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        raise RecordingError(
            f"{path}: {name} has {bad.size} samples that are no finite number, the first at sample {bad[0]}; cut the "
            "file to a span without them"
        )


__all__ = ["Track", "Tracks", "tracks_of"]
