"""All tracks of one or several files as one recording."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from torquerig.errors import InputError, RecordingError, did_you_mean
from torquerig.recordings.files.number_table import distinct
from torquerig.recordings.joining.alignment import shift_between
from torquerig.recordings.joining.resampling import is_stepped, resampled
from torquerig.recordings.joining.tracks import LONGEST_GAP, Track, Tracks, split_tracks, tracks_of
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run


@dataclass(frozen=True)
class Joined:
    """The recording, and one sentence for each thing that was done."""

    recording: Recording
    notes: tuple[str, ...]


def join_recordings(
    paths: Sequence[Path], *, rate: float | None = None, align: str = "start", longest_gap: float = LONGEST_GAP
) -> Joined:
    """Return the columns of the files as one recording at one rate, over the time that all of them cover.

    Parameters
    ----------
    paths : sequence of Path
        One file whose columns have several rates or uneven times, or several files of one run.
    rate : float, optional
        [Hz]; the highest rate of the columns when not given.
    align : str
        ``start``: all files begin at once; ``clock``: by their columns of times; else the name of a channel that all
        files have, by whose correlation they are shifted.
    longest_gap : float
        Longest pause that is bridged by straight lines [s].

    Raises
    ------
    InputError, RecordingError
        Files that cannot be read, have no common time, no such channel, or contradicting test conditions.
    """
    return _joined([tracks_of(path, longest_gap=longest_gap) for path in paths], rate=rate, align=align)


def split_recording(path: Path, *, rate: float | None = None, longest_gap: float = LONGEST_GAP) -> tuple[Joined, ...]:
    """Return the stretches of one file between pauses longer than ``longest_gap`` [s], each as a recording.

    ``rate`` [Hz] is common to all; the highest rate of the columns in the first stretch when not given.
    """
    parts = split_tracks(path, longest_gap=longest_gap)
    common = rate or max(track.rate for track in parts[0].tracks.values())
    return tuple(_joined([part], rate=common, align="start") for part in parts)


def _joined(files: Sequence[Tracks], *, rate: float | None, align: str) -> Joined:
    paths = [one.path for one in files]
    offsets, notes = _offsets(files, align)
    tracks = _named(files, offsets)
    common = rate or max(track.rate for track in tracks.values())
    first = max(track.start for track in tracks.values())
    last = min(track.start + track.values.size / track.rate for track in tracks.values())
    samples = int(np.floor((last - first) * common + 1e-6))
    if samples < 2:
        raise RecordingError(
            f"{', '.join(str(path) for path in paths)}: the columns have no common time; check --align ({align})"
        )
    channels, changed = {}, []
    for name, track in tracks.items():
        values = resampled(track, rate=common, start=first, samples=samples)
        channels[name] = track.entry.channel(values)
        if abs(track.rate / common - 1) > 1e-12:
            how = "last samples held" if is_stepped(track) else "interpolated" if track.rate < common else "low-passed"
            changed.append(f"{name}: {track.rate:g} Hz to {common:g} Hz, {how}")
    said = tuple(note for one in files for note in one.notes) + tuple(notes) + tuple(changed)
    origin = {"joined": [path.name for path in paths], "notes": list(said)}
    recording = Recording(sample_rate=common, channels=channels, run=_run(files), origin=origin, name=paths[0].name)
    return Joined(recording, said)


def _offsets(files: Sequence[Tracks], align: str) -> tuple[list[float], list[str]]:
    """Return what is added to the times of each file [s], and what was done."""
    if align == "start" or len(files) == 1:
        return [-min(track.start for track in one.tracks.values()) for one in files], []
    if align == "clock":
        for one in files:
            if not one.has_clock:
                raise InputError(
                    f"{one.path}: it states no start and has no column of times; align by a common channel, or by start"
                )
        return [0.0] * len(files), []
    for one in files:
        if align not in one.tracks:
            raise InputError(
                f"{one.path}: there is no channel {align!r} to align by; {did_you_mean(align, one.tracks)}"
            )
    reference = files[0].tracks[align]
    offsets, notes = [-reference.start], []
    for one in files[1:]:
        track = one.tracks[align]
        count = int(track.values.size / track.rate * reference.rate)
        values = resampled(track, rate=reference.rate, start=track.start, samples=count)
        shift = shift_between(reference.values, values, rate=reference.rate, name=align)
        offsets.append(shift.seconds - track.start)
        notes.append(
            f"{one.path.name} begins {shift.seconds:.6g} s after {files[0].path.name} "
            f"(correlation of {align}: {shift.correlation:.3f})"
        )
    return offsets, notes


def _named(files: Sequence[Tracks], offsets: Sequence[float]) -> dict[str, Track]:
    """Return all tracks by distinct names, on one clock."""
    every = [(track, offset) for one, offset in zip(files, offsets, strict=True) for track in one.tracks.values()]
    names = distinct(track.name for track, _ in every)
    return {
        name: Track(name=name, values=track.values, rate=track.rate, start=track.start + offset, entry=track.entry)
        for name, (track, offset) in zip(names, every, strict=True)
    }


def _run(files: Sequence[Tracks]) -> Run:
    stated = [one for one in files if one.run != Run()]
    for one in stated[1:]:
        if one.run != stated[0].run:
            raise InputError(
                f"{one.path}: its sidecar states other test conditions than that of {stated[0].path.name}; correct one"
            )
    return stated[0].run if stated else Run()
