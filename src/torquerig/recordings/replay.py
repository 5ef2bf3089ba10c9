"""Replay of a recorded torque or motion as the input of a simulated run.

Before the recording starts, its first value (of a motion: its first speed) is held. At another sample rate the cubic
spline through the samples is used. Where the run's rate is lower, a low-pass below half of it is applied first.

Source: de Boor 2001, A Practical Guide to Splines, chapter IV (not-a-knot). Accurate to 1e-3 up to a sixth of the
recording's rate; higher frequencies are attenuated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError, RecordingError, did_you_mean
from torquerig.recordings.channel_angle import angle_of
from torquerig.recordings.recording import Channel, Recording

Floats = NDArray[np.float64]

TORQUES = ("torque", "motor_torque", "force", "current")
ANGLES = ("motor_angle", "angle", "position")
SPEEDS = ("motor_speed", "speed", "velocity")
KEPT_BAND = 0.4  # of the lower rate: corner of the low-pass before decimation


@dataclass(frozen=True, eq=False)
class ReplayedTorque:
    """A recorded torque [N m] or force [N] at ``rate`` [Hz]; ``label`` names channel and file in messages."""

    values: Floats
    rate: float
    label: str
    quantity: str = "torque"

    def at(self, time: Floats) -> Floats:
        """Return the torque at equally spaced times [s]; InputError where they go beyond the recording."""
        _refuse_longer(self, time)
        index = time * self.rate
        whole = np.round(index).astype(np.int64)
        same_rate = abs((time[1] - time[0]) * self.rate - 1) < 1e-9
        if same_rate and np.allclose(index, whole, rtol=0, atol=1e-6):  # the samples themselves, no interpolation
            return np.asarray(self.values[np.clip(whole, 0, self.values.size - 1)])
        return np.asarray(_spline(self, time)(np.clip(time, 0.0, (self.values.size - 1) / self.rate)))


@dataclass(frozen=True, eq=False)
class ReplayedMotion:
    """A recorded angle [rad] or position [m] at ``rate`` [Hz]; where ``speeds``, a speed [rad/s] or [m/s]."""

    values: Floats
    rate: float
    label: str
    speeds: bool
    quantity: str = "angle"

    def at(self, time: Floats) -> tuple[Floats, Floats]:
        """Return angle and speed at equally spaced times [s]; InputError where they go beyond the recording."""
        _refuse_longer(self, time)
        curve = _spline(self, time)
        angle, speed = (curve.antiderivative(), curve) if self.speeds else (curve, curve.derivative())
        within = np.clip(time, 0.0, (self.values.size - 1) / self.rate)
        turning = np.asarray(speed(within))
        return np.asarray(angle(within)) + turning * (time - within), turning


def replayed_torque(
    recording: Recording, channel: str, *, factor: float = 1.0, torque_constant: float | None = None
) -> ReplayedTorque:
    """Return the torque of a channel, named by its name or its quantity, times ``factor``.

    Parameters
    ----------
    torque_constant : float, optional
        [N m/A], for a current.

    Raises
    ------
    RecordingError
        No such channel; one that is no torque; gaps; a current without torque constant.
    """
    name, found = _channel(recording, channel)
    label = f"{name} of {recording.name}"
    if found.quantity not in TORQUES:
        raise RecordingError(f"{label} is a {found.quantity}, not a torque; name a channel of {', '.join(TORQUES)}")
    if found.quantity == "current" and torque_constant is None:
        raise RecordingError(f"{label} is a current; add torque_constant:, such as 0.11 N*m/A")
    scale = factor * (torque_constant or 1.0) if found.quantity == "current" else factor
    values = scale * _whole(found, label, recording.sample_rate)
    return ReplayedTorque(values, recording.sample_rate, label, found.quantity)


def replayed_motion(recording: Recording, channel: str, *, factor: float = 1.0) -> ReplayedMotion:
    """Return the motion of an angle or speed channel, named by its name or its quantity, times ``factor``.

    Counts are unwrapped and smoothed (``recordings.channel_angle``). RecordingError as for ``replayed_torque``.
    """
    name, found = _channel(recording, channel)
    label = f"{name} of {recording.name}"
    if found.quantity not in (*ANGLES, *SPEEDS):
        raise RecordingError(
            f"{label} is a {found.quantity}, and a motion needs an angle or a speed; name a channel of "
            f"{', '.join((*ANGLES, *SPEEDS))}"
        )
    values, speeds = _whole(found, label, recording.sample_rate), found.quantity in SPEEDS
    if not speeds:
        values = angle_of(found, recording.sample_rate)
    return ReplayedMotion(factor * values, recording.sample_rate, label, speeds, found.quantity)


def recording_at(path: Path) -> Recording:
    """Return the recording of a file, read once for as long as the file stays the same."""
    return _read(path, path.stat().st_mtime_ns if path.is_file() else 0)


@lru_cache(maxsize=4)
def _read(path: Path, changed: int) -> Recording:
    from torquerig.recordings.files.reading import read_recording

    return read_recording(path)


def _channel(recording: Recording, wanted: str) -> tuple[str, Channel]:
    channels: Mapping[str, Channel] = recording.channels
    alike = [name for name, one in channels.items() if one.quantity == wanted and not one.truth]
    inputs = [name for name in alike if channels[name].role == "input"] or alike
    if wanted not in channels and len(inputs) > 1:
        raise RecordingError(
            f"{recording.name}: several channels are a {wanted}: {', '.join(inputs)}; name one with channel:"
        )
    name = wanted if wanted in channels else next(iter(inputs), None)
    if name is None:
        known = [*channels, *(one.quantity for one in channels.values())]
        raise RecordingError(f"{recording.name} has no channel {wanted!r}; {did_you_mean(wanted, known)}")
    return name, channels[name]


def _whole(channel: Channel, label: str, rate: float) -> Floats:
    values = channel.in_si()
    bad = ~np.isfinite(values)
    if bad.any():
        first = int(np.argmax(bad))
        raise RecordingError(
            f"{label} has a gap of {int(bad.sum())} samples that are not numbers, from {first / rate:.6g} s on; replay "
            "a recording cut to a span without them"
        )
    if values.size < 4:
        raise RecordingError(f"{label} has {values.size} samples; a replay needs at least 4")
    return values


def _refuse_longer(signal: ReplayedTorque | ReplayedMotion, time: Floats) -> None:
    """Refuse times after the last sample; the last time is the end of the run's last step and may exceed it by one."""
    last = (signal.values.size - 1) / signal.rate
    if time[-2] > last + 1e-9:
        raise InputError(
            f"{signal.label} lasts {signal.values.size / signal.rate:.6g} s, and the run {time[-1]:.6g} s; make the "
            "run shorter, or replay a longer recording"
        )


def _spline(signal: ReplayedTorque | ReplayedMotion, time: Floats) -> Any:
    """Return the spline through the samples over time [s], low-passed where the rate of ``time`` is lower."""
    from scipy.interpolate import CubicSpline

    values, rate = signal.values, 1 / (time[1] - time[0])
    if rate < signal.rate * (1 - 1e-9):
        from scipy.signal import butter, sosfiltfilt

        values = sosfiltfilt(butter(8, KEPT_BAND * rate, fs=signal.rate, output="sos"), values)
    return CubicSpline(np.arange(values.size) / signal.rate, values)
