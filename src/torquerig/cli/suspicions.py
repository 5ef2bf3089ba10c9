"""Suspicious samples of a recording, in the same sentences from every command."""

from __future__ import annotations

import click

from torquerig.orders.angle.speed_contradictions import speed_contradictions
from torquerig.orders.angle.suspicions import choice_sentences, suspicions_in
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.recording_info import RecordingInfo, recording_info
from torquerig.recordings.inspection.stretch_faults import first_stretch, head_of, sound_stretch, stretch_faults
from torquerig.recordings.recording import Recording


def print_suspicions(info: RecordingInfo, head: Recording, *, note: str | None = None) -> list[str]:
    """Print and return what is suspicious in a recording, and where it was sought if that is not all of it.

    Parameters
    ----------
    info : RecordingInfo
        Of the whole recording.
    head : Recording
        Its first samples, or all.
    note : str, optional
        What the command does with suspicious samples; printed where there are some.
    """
    found, where = suspicions_in(info, head)
    _print(found, note)
    if where is not None:
        click.echo(where)
    return found


def print_suspicions_of_start(stream: RecordingStream, *, note: str) -> None:
    """Print what is suspicious in the first stretch of a recording that is read block by block; ``note`` as above."""
    start = first_stretch(head_of(stream))
    info = recording_info(start)
    contradictions = speed_contradictions(sound_stretch(start)[1])
    _print(
        [*choice_sentences(start), *contradictions, *info.suspicions(stretch_faults(start, samples=info.samples))], note
    )
    if start.samples != stream.samples:
        click.echo(f"faults of samples were sought in the first {start.duration:.3g} s")


def _print(sentences: list[str], note: str | None) -> None:
    for sentence in sentences:
        click.echo(f"suspicious: {sentence}")
    if sentences and note is not None:
        click.echo(note)
