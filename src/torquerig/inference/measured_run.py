"""A recording that is ready to be compared: torque, angle and speed of the motor, and its blocks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import speed_of
from torquerig.diagnosis.looking.shaft_angle import shaft_angles
from torquerig.inference.blocks import Block, blocks_of
from torquerig.orders.angle.measured_angle import measured_motor_angle
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import Run
from torquerig.recordings.tacho_edges import rising_edges
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

MEASURED_TIME, UNMEASURED_TIME = 0.005, 0.04  # [s]
UNMEASURED_ANGLE = 0.012  # [1] relative scatter of the speed around one that was estimated from the torque


@dataclass(frozen=True, kw_only=True, eq=False)
class MeasuredRun:
    """One run of the rig that is diagnosed.

    Parameters
    ----------
    recording : Recording
        As read; its set-point is the speed at which the run really turned.
    torque : ndarray, shape (samples,)
        Measured torque [N m], or force [N] on a rig that moves in a line.
    angle, speed : ndarray, shape (samples,)
        Of the motor [rad], [rad/s]; the speed is a mean over 50 ms.
    has_encoder : bool
        Whether a channel of the recording gave the angle.
    speed_factor : float
        Real speed over the stated set-point [1].
    blocks : tuple of Block
    followed : float
        Up to this frequency [Hz] the angle follows the sway of the shaft: any with an encoder, half the pulses per
        second of a tacho, none where the angle was not measured.
    angle_noise : float
        Density of the error of the angle up to there [rad^2/Hz].
    """

    recording: Recording
    torque: Floats
    angle: Floats
    speed: Floats
    has_encoder: bool
    speed_factor: float
    blocks: tuple[Block, ...]
    followed: float = float("inf")
    angle_noise: float = 0.0

    @property
    def name(self) -> str:
        """The name of the file."""
        return self.recording.name

    @property
    def rate(self) -> float:
        """Samples per second [Hz]."""
        return self.recording.sample_rate

    @property
    def run(self) -> Run:
        """The conditions of the run."""
        return self.recording.run

    @property
    def time_error(self) -> float:
        """Standard deviation of the time between torque and speed [s]: filters, and an angle that was not measured."""
        return MEASURED_TIME if self.has_encoder else UNMEASURED_TIME

    def smearing(self, samples: slice) -> float:
        """Return the relative width over which lines are spread in a part because the angle was not measured [1]."""
        if self.has_encoder:
            return 0.0
        speed = self.speed[samples]
        changed = abs(float(speed[-1] - speed[0])) / max(speed.size - 1, 1) * self.rate
        late = 0.0 if self.is_steady else changed * self.time_error / max(float(np.abs(speed).mean()), 1e-12)
        return UNMEASURED_ANGLE + late

    @property
    def is_steady(self) -> bool:
        """Whether the set-point of the speed was constant."""
        return self.run.profile == "steady"


def measured_runs(recordings: Sequence[Recording], rig: Rig) -> tuple[MeasuredRun, ...]:
    """Return the recordings with the angle of the motor: measured, or estimated from the torque or the set-point."""
    return tuple(
        _measured_run(recording, angle.values * _direction(recording, angle.factor), has_encoder=angle.measured,
                      factor=angle.factor * _direction(recording, angle.factor))
        for recording, angle in zip(recordings, shaft_angles(recordings, rig), strict=True)
    )  # fmt: skip


def _direction(recording: Recording, factor: float) -> float:
    """Return -1 where a tacho, which does not show the direction, was read against that of the set-point; else 1."""
    return -1.0 if factor < 0 and recording.find("tacho") is not None else 1.0


def _measured_run(recording: Recording, angle: Floats, *, has_encoder: bool, factor: float) -> MeasuredRun:
    """Return the run; an angle that was not measured is that of a constant speed where the set-point is constant.

    How the shaft sways about it is then the model's to tell, without the errors of an estimate.
    """
    run, rate = recording.run, recording.sample_rate
    held = replace(run, speed=None if run.speed is None else run.speed * factor)
    is_steady = run.profile == "steady"  # what an encoder scatters by is no change of the speed
    if is_steady and not has_encoder:
        angle = np.linspace(angle[0], angle[-1], angle.size)
    speed = speed_of(angle, rate)
    course = np.full(speed.size, float(speed.mean())) if is_steady else speed
    followed, noise = _followed(recording, speed) if has_encoder else (0.0, 0.0)
    return MeasuredRun(
        recording=replace(recording, run=held), torque=recording.torque(), angle=angle, speed=speed,
        has_encoder=has_encoder, speed_factor=factor, blocks=blocks_of(course, rate), followed=followed,
        angle_noise=noise,
    )  # fmt: skip


def _followed(recording: Recording, speed: Floats) -> tuple[float, float]:
    """Return up to which frequency a measured angle follows the shaft [Hz], and the density of its error [rad^2/Hz].

    The edges of a tacho are rounded to a sample: their times have the variance 1/12 of its square.
    """
    tacho = None if measured_motor_angle(recording) is not None else recording.find("tacho")
    if tacho is None:
        return float("inf"), 0.0
    pulses = rising_edges(recording.channels[tacho].values).size / recording.duration
    rounding = float(np.square(speed).mean()) / (12 * recording.sample_rate**2)
    return 0.5 * pulses, 2 * rounding / pulses
