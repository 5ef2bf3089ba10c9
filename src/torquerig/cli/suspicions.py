"""Suspicious samples of a recording, in the same sentences from every command."""

from __future__ import annotations

from math import pi

import click

from torquerig.orders.angle.speed_contradictions import speed_contradictions
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.inspection.recording_info import RecordingInfo, recording_info
from torquerig.recordings.inspection.stretch_faults import first_stretch, head_of, sound_stretch, stretch_faults
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.angle_jumps import angle_jumps


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


def suspicions_in(info: RecordingInfo, head: Recording) -> tuple[list[str], str | None]:
    """Return what is suspicious in a recording, and where it was sought if that is not all; arguments as above."""
    stretch = stretch_faults(head, samples=info.samples)
    contradictions = speed_contradictions(sound_stretch(head)[1])
    return [*_choice(head), *contradictions, *info.suspicions(stretch)], None if stretch is None else stretch.where()


def print_suspicions_of_start(stream: RecordingStream, *, note: str) -> None:
    """Print what is suspicious in the first stretch of a recording that is read block by block; ``note`` as above."""
    start = first_stretch(head_of(stream))
    info = recording_info(start)
    contradictions = speed_contradictions(sound_stretch(start)[1])
    _print([*_choice(start), *contradictions, *info.suspicions(stretch_faults(start, samples=info.samples))], note)
    if start.samples != stream.samples:
        click.echo(f"faults of samples were sought in the first {start.duration:.3g} s")


def angle_sentences(recording: Recording, *, ratio: float | None = None) -> list[str]:
    """Return what is suspicious in the angle and speed channels alone, jumps too.

    ``ratio`` [1] is that of the gears, by default that of the run.
    """
    sound = sound_stretch(recording)[1]
    found = list(speed_contradictions(sound, ratio=ratio))
    jumps = angle_jumps(sound)
    if jumps:
        first, furthest = jumps[0], max(abs(one.turn) for one in jumps) / (2 * pi)
        found.append(
            f"{first.channel} jumps {len(jumps)} times, first at {first.start / sound.sample_rate:.6g} s, by up to "
            f"{furthest:.2g} turns from one sample to the next: counts or samples were lost or written twice"
        )
    return found


def _choice(recording: Recording) -> list[str]:
    """Return a sentence where several channels may be the measured torque, and the sidecar does not say which."""
    for quantity in ("torque", "force"):
        named = {
            name: one.role for name, one in recording.channels.items()
            if one.quantity == quantity and one.role in (None, "compared") and not one.truth
        }  # fmt: skip
        if len(named) > 1 and "compared" not in named.values():
            remedy = "write role: compared into the sidecar for the one that counts, or name it with --channel"
            return [f"several channels are a {quantity}: {', '.join(named)}; {remedy}"]
        if named:
            return []
    return []


def _print(sentences: list[str], note: str | None) -> None:
    for sentence in sentences:
        click.echo(f"suspicious: {sentence}")
    if sentences and note is not None:
        click.echo(note)
