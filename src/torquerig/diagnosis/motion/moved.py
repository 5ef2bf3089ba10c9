"""A run under measured motion made ready to compare: what the motion took, where it went, and what fits may see."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.effort_samples import EffortFaults, effort_faults
from torquerig.errors import InputError, RecordingError
from torquerig.recordings.effort import effort_of
from torquerig.recordings.inputs import input_channel
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.replay import replayed_motion
from torquerig.recordings.sampled_motion import SampledMotion, low_passed
from torquerig.rig.assembly import Rig
from torquerig.rig.imposed_part import imposed_part
from torquerig.rig.parts import ImposedMotion

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

BAND = 0.1  # of the sample rate: motion and effort are compared below it; beyond, the second derivative is noise
STRETCHES = 10  # of a run; every other one is held out where no whole run is
_EDGE = 3.0  # periods of the band's edge at either end, where the low-pass has nothing to look at
_FEWEST = 400


@dataclass(frozen=True, eq=False)
class Moved:
    """One run.

    Parameters
    ----------
    recording : Recording
    motion : SampledMotion
        Low-passed.
    effort, position, speed : ndarray, shape (samples,)
        What the motion took [N m] or [N], low-passed; [rad] or [m]; per second.
    seen, held : ndarray of bool, shape (samples,)
        What fits may see, and what they may not; neither at the very ends.
    channel : Channel
        That of the effort, for its unit.
    """

    recording: Recording
    motion: SampledMotion
    effort: Floats
    position: Floats
    speed: Floats
    seen: Mask
    held: Mask
    channel: Channel

    @property
    def name(self) -> str:
        """The file's name."""
        return self.recording.name

    @property
    def rate(self) -> float:
        """Samples per second [Hz]."""
        return self.recording.sample_rate


def under_measured_motion(rig: Rig) -> bool:
    """Whether a scenario measures what the motion of each recording takes."""
    return imposed_part(rig) is not None


def moved(
    recording: Recording, part: ImposedMotion, *, held_out: bool | None = None, mended: Floats | None = None,
    spoilt: Mask | None = None,
) -> Moved:  # fmt: skip
    """Return a run made ready; ``held_out`` True holds it back whole, False gives it to the fits, None parts it.

    Parameters
    ----------
    mended : ndarray, shape (samples,), optional
        The effort in the channel's unit, in place of what the channel has.
    spoilt : ndarray of bool, shape (samples,), optional
        Samples that neither fits nor judgement may use.

    Raises
    ------
    RecordingError
        Without a channel of effort or motion, or with gaps in one of them; too short to tell anything.
    """
    channel = effort_of(recording)
    if recording.samples < _FEWEST:
        raise RecordingError(
            f"{recording.name}: {recording.samples} samples of motion are too few for a diagnosis; record at least "
            f"{_FEWEST}"
        )
    rate = recording.sample_rate
    moving = input_channel(recording, part.wanted, at=part.at)
    raw = replayed_motion(recording, moving, factor=part.factor)
    curve = replace(raw, values=low_passed(raw.values, BAND))
    time = np.arange(recording.samples + 1) / rate  # a run ends a sample behind its last
    motion = SampledMotion(curve, time, *curve.at(time))
    position, speed = motion.angle[:-1], motion.speed[:-1]
    if not np.ptp(position) > 0:
        raise RecordingError(f"{recording.name}: nothing moves; use a recording with motion")
    inner = np.zeros(recording.samples, dtype=bool)
    if not np.any(channel.values):
        raise RecordingError(f"{recording.name}: its torque or force is always zero; use a recording that measures it")
    edge = min(round(_EDGE / BAND), recording.samples // 20)
    inner[edge:-edge] = True
    if spoilt is not None:
        inner &= ~spoilt
        if inner.sum() < 0.5 * _FEWEST:
            raise RecordingError(
                f"{recording.name}: only {inner.sum()} samples are neither limit nor dropout; omit this recording, "
                "or record it within the range"
            )
    effort = channel.in_si() if mended is None else replace(channel, values=mended).in_si()
    seen = _parted(recording.samples) if held_out is None else np.full(recording.samples, not held_out)
    return Moved(
        recording=replace(recording, sample_rate=rate), motion=motion, effort=low_passed(effort, BAND),
        position=position, speed=speed, seen=inner & seen, held=inner & ~seen, channel=channel,
    )  # fmt: skip


def moved_runs(
    recordings: Sequence[Recording], rig: Rig, *, held_out: Sequence[str] = (), faults: EffortFaults | None = None
) -> tuple[Moved, ...]:
    """Return all runs made ready: those named are held out whole; where none is, each is parted in stretches.

    ``faults`` are those of the efforts' samples, found here where they are not given.
    """
    part = imposed_part(rig)
    if part is None:
        raise InputError(
            "the scenario measures no imposed motion; add {kind: imposed_motion, at: PART, channel: position} and name "
            "it under measured:"
        )
    unknown = set(held_out) - {recording.name for recording in recordings}
    if unknown:
        raise InputError(f"no recording is named {sorted(unknown)[0]!r}; name one of the recordings to hold out")
    found = faults_in(recordings) if faults is None else faults
    return tuple(
        moved(one, part, held_out=one.name in held_out if held_out else None, mended=mended, spoilt=spoilt)
        for one, mended, spoilt in zip(recordings, found.efforts, found.spoilt, strict=True)
    )


def faults_in(recordings: Sequence[Recording], *, limits: bool = True) -> EffortFaults:
    """Return the faults of the recordings' efforts; without ``limits`` a level that they stop at is the drive's."""
    return effort_faults(recordings, [effort_of(each) for each in recordings], limits=limits)


def _parted(samples: int) -> Mask:
    """Whether fits may see a sample: every other stretch."""
    return np.asarray(np.arange(samples) * STRETCHES // samples % 2 == 0)
