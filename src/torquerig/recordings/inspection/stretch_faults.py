"""Faults of the samples of a recording's first stretch: the same in all commands, at a cost without growth."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from torquerig.recordings.files.blocks import Blocking
from torquerig.recordings.files.stream import RecordingStream
from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.faults import Fault
from torquerig.recordings.repair.recording_faults import MEASURED, recording_faults

STRETCH = 2**20
"""Samples that are examined at most: 42 s at 25 kHz, some 2 s of computing time and 200 MB."""


@dataclass(frozen=True, kw_only=True)
class StretchFaults:
    """The faults of samples ``first`` to before ``stop`` at ``rate`` [Hz]; their times count from ``first``.

    ``whole`` is whether that is all of the recording.
    """

    faults: tuple[Fault, ...]
    first: int
    stop: int
    rate: float
    whole: bool

    def where(self) -> str | None:
        """Return in one sentence where faults were sought, None where that is the whole recording."""
        if self.whole:
            return None
        seconds = (self.stop - self.first) / self.rate
        if self.first == 0:
            return f"faults of the torque's samples were sought in the first {seconds:.3g} s"
        return (
            f"faults of the torque's samples were sought in samples {self.first}..{self.stop - 1} ({seconds:.3g} s), "
            f"the longest stretch without gaps; times count from sample {self.first}"
        )


def head_of(stream: RecordingStream) -> Recording:
    """Return the first samples of a recording on disk; at least the first stretch, or all of a shorter one."""
    return next(Blocking(samples=STRETCH).cut(stream)).without_overlap()


def first_stretch(recording: Recording) -> Recording:
    """Return the samples of a recording that are examined, which is all of a short one."""
    return _cut(recording, 0, STRETCH)


def stretch_faults(recording: Recording, *, samples: int) -> StretchFaults | None:
    """Return the faults of the first stretch of a recording; None where it has no measured torque or force.

    Parameters
    ----------
    recording : Recording
        All of it, or its first samples; it may hold samples that are no numbers.
    samples : int
        Of the whole recording.
    """
    measured = [one for one in recording.channels.values() if one.quantity in MEASURED and not one.truth]
    if not measured:
        return None
    first, sound = sound_stretch(first_stretch(recording))
    return StretchFaults(
        faults=recording_faults(sound), first=first, stop=first + sound.samples, rate=recording.sample_rate,
        whole=sound.samples == samples,
    )  # fmt: skip


def sound_stretch(head: Recording) -> tuple[int, Recording]:
    """Return the longest stretch in which every channel that has numbers has them, and its first sample."""
    finite = {name: np.isfinite(one.values) for name, one in head.channels.items()}
    kept = {name: one for name, one in head.channels.items() if finite[name].any()}
    sound = np.logical_and.reduce([finite[name] for name in kept]) if kept else np.zeros(head.samples, dtype=bool)
    ends = np.flatnonzero(np.diff(np.concatenate([[0], sound.astype(np.int8), [0]])))
    if not ends.size:
        return 0, head
    longest = int(np.argmax(ends[1::2] - ends[::2]))
    first, last = int(ends[2 * longest]), int(ends[2 * longest + 1])
    return first, _cut(replace(head, channels=kept), first, last)


def _cut(recording: Recording, first: int, last: int) -> Recording:
    channels = {name: replace(one, values=one.values[first:last]) for name, one in recording.channels.items()}
    return replace(recording, channels=channels)
