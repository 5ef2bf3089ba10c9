"""A recording whose motion is imposed on the model: its motion, its effort, and the frames that fits may use."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, RecordingError
from torquerig.inference.motion.lapped import frames_of, frequencies, from_lapped, lapped
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

BAND = 0.1  # of the sample rate: above it the second derivative of a coarse scale is mostly noise
_FEWEST = 400  # samples: ten frames of 40, of which eight frequencies are compared
_FRAMES = 24  # of a run: long enough for slow effects, and enough of them to hold a third out
_EDGE = 30  # samples at either end that the low-pass of the motion disturbs, three periods of the band's edge


@dataclass(frozen=True, eq=False)
class ImposedRun:
    """One recording.

    Parameters
    ----------
    recording : Recording
    motion : SampledMotion
        Low-passed at ``BAND`` of the sample rate.
    effort : ndarray, shape (samples,)
        Measured [N m] or [N].
    channel : Channel
        Of the effort, for its unit.
    bins : int
        Distance of two frames in samples.
    seen, held : ndarray of bool, shape (frames,)
        Frames that are fitted, and those that judge.
    """

    recording: Recording
    motion: SampledMotion
    effort: Floats
    channel: Channel
    bins: int
    seen: Mask
    held: Mask

    @property
    def name(self) -> str:
        """The file's name."""
        return self.recording.name

    @property
    def rate(self) -> float:
        """Sample rate [Hz]."""
        return self.recording.sample_rate

    @property
    def position(self) -> Floats:
        """Measured position, shape (samples,) [rad] or [m]."""
        return self.motion.angle[:-1]

    @property
    def speed(self) -> Floats:
        """Its derivative, shape (samples,)."""
        return self.motion.speed[:-1]

    @property
    def time(self) -> Floats:
        """Time of the samples [s]."""
        return self.motion.time[:-1]

    @property
    def frequencies(self) -> Floats:
        """Frequency of each coefficient of a frame [Hz]."""
        return frequencies(self.bins, band=BAND, rate=self.rate)

    def transformed(self, values: Floats) -> Floats:
        """Return the coefficients of a signal of this run, shape (frames, bins); the ends are left out."""
        return lapped(values[_EDGE:-_EDGE], self.bins, band=BAND)

    def signal(self, coefficients: Floats) -> Floats:
        """Return the signal of coefficients of this run, shape (samples,); zero at the ends."""
        inner = from_lapped(coefficients, self.bins, self.effort.size - 2 * _EDGE)
        return np.concatenate([np.zeros(_EDGE), inner, np.zeros(_EDGE)])

    def samples_of(self, frames: Mask) -> Mask:
        """Return the samples in the middle halves of frames, shape (samples,)."""
        inside = np.zeros(self.effort.size, dtype=bool)
        for frame in np.flatnonzero(frames):
            start = _EDGE + frame * self.bins + self.bins // 2
            inside[start : start + self.bins] = True
        return inside


def imposed_runs(
    recordings: Sequence[Recording], rig: Rig, *, held_out: Sequence[str] = ()
) -> tuple[ImposedRun, ...]:  # fmt: skip
    """Return the recordings made ready; those named are held out whole, without names every third frame of each.

    Raises
    ------
    InputError
        Where the rig has no imposed motion, or ``held_out`` names no recording or all of them.
    RecordingError
        Where a recording has no effort or motion, has gaps, or is too short.
    """
    part = imposed_part(rig)
    if part is None:
        raise InputError(
            "the scenario measures no imposed motion; add {kind: imposed_motion, at: PART, channel: position} and name "
            "it under measured:"
        )
    names = [one.name for one in recordings]
    unknown = sorted(set(held_out) - set(names))
    if unknown:
        raise InputError(f"--held-out {unknown[0]}: no recording has this name; choose among {', '.join(names)}")
    if held_out and set(held_out) >= set(names):
        raise InputError("--held-out names every recording; leave at least one for the fit")
    return tuple(_run(one, part, held=one.name in held_out if held_out else None) for one in recordings)


def _run(recording: Recording, part: ImposedMotion, *, held: bool | None) -> ImposedRun:
    channel, samples, rate = effort_of(recording), recording.samples, recording.sample_rate
    if samples < _FEWEST:
        raise RecordingError(
            f"{recording.name}: {samples} samples of motion are too few for a diagnosis; record at least {_FEWEST}"
        )
    raw = replayed_motion(recording, input_channel(recording, part.wanted, at=part.at), factor=part.factor)
    curve = replace(raw, values=low_passed(raw.values, BAND))
    time = np.arange(samples + 1) / rate  # a run ends a sample after its last
    motion = SampledMotion(curve, time, *curve.at(time))
    if not np.ptp(motion.angle) > 0:
        raise RecordingError(f"{recording.name}: nothing moves; use a recording with motion")
    if not np.any(channel.values):
        raise RecordingError(f"{recording.name}: its torque or force is always zero; use a recording that measures it")
    bins = (samples - 2 * _EDGE) // (_FRAMES + 1) if samples > 40 * _FRAMES else max(16, samples // 24)
    count = frames_of(samples - 2 * _EDGE, bins)
    out = np.arange(count) % 3 == 1 if held is None else np.full(count, held)
    return ImposedRun(recording, motion, channel.in_si(), channel, bins, ~out, out)
