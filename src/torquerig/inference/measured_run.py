"""A recording that is ready to be compared: torque, angle and speed of the motor, and its blocks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.blocks import Block, blocks_of
from torquerig.inference.kept import Kept
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle, shaft_angles
from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.inference.motor_angle.tacho_direction import directed
from torquerig.orders.angle.measured_angle import measured_motor_angle
from torquerig.recordings.recording import Recording
from torquerig.recordings.run import WANDER_CUTOFF, Run
from torquerig.recordings.set_point import set_point_profile
from torquerig.recordings.tacho_edges import rising_edges
from torquerig.rig.assembly import Rig

Floats = NDArray[np.float64]

_OF_A_PERIOD = 0.1  # of the time between two pulses: what interpolation between them may be off by
_FEWEST_PULSES = 3  # in a part whose orders are looked for
_SLOWEST = 1e-3  # [rad/s]
_WINDOW = 1 / 240  # of a run, over which its speed is a mean: a fifth of the shortest block
MEASURED_TIME, UNMEASURED_TIME = 0.1, 0.8  # of this window: standard deviation of the time between torque and speed
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
        Of the motor [rad], [rad/s]; the speed is a mean over ``window``.
    has_encoder : bool
        Whether a channel of the recording gave the angle.
    speed_factor : float
        Real speed over the stated set-point [1].
    blocks : tuple of Block
    pulses : float
        Of a tacho per turn of the motor [1]; infinite without one.
    followed : float
        Up to this frequency [Hz] the angle follows the sway of the shaft: any with an encoder, half the pulses per
        second of a tacho, none where the angle was not measured.
    angle_noise : float
        Density of the error of the angle up to there [rad^2/Hz].
    lost : ndarray of bool, shape (samples,), optional
        Which samples hold no signal; None where all do.
    wander, wander_cutoff : float
        Relative rms of the slow wander of a steady speed [1] and its bandwidth [Hz], as the scenario states them.
    """

    recording: Recording
    torque: Floats
    angle: Floats
    speed: Floats
    has_encoder: bool
    speed_factor: float
    blocks: tuple[Block, ...]
    pulses: float = float("inf")
    followed: float = float("inf")
    angle_noise: float = 0.0
    lost: NDArray[np.bool_] | None = None
    wander: float = 0.0
    wander_cutoff: float = WANDER_CUTOFF

    @cached_property
    def kept(self) -> Kept:
        """What was simulated for this run."""
        return Kept()

    @cached_property
    def mean_speed(self) -> float:
        """Mean speed of the motor, without its direction [rad/s]."""
        return float(np.abs(self.speed).mean())

    @property
    def name(self) -> str:
        """The name of the file."""
        return self.recording.name

    @property
    def rate(self) -> float:
        """Samples per second [Hz]."""
        return self.recording.sample_rate

    @property
    def window(self) -> float:
        """The time over which the speed is a mean [s]."""
        return _WINDOW * self.recording.duration

    @property
    def slowest(self) -> float:
        """Two bins of the longest block [Hz]: the mean torques show what is slower, lines and bands what is faster."""
        return 2 * self.rate / max(block.stop - block.start for block in self.blocks)

    @property
    def run(self) -> Run:
        """The conditions of the run."""
        return self.recording.run

    def time_error(self, speed: Floats) -> Floats:
        """Return the standard deviation of the time between torque and speed [s] at speeds of the motor [rad/s].

        It comes from filters, from an angle that was not measured, and from the time between two pulses of a tacho.
        """
        least = np.full(speed.shape, self.window * (MEASURED_TIME if self.has_encoder else UNMEASURED_TIME))
        if np.isinf(self.pulses):
            return least
        period = 2 * pi / (self.pulses * np.maximum(np.abs(speed), _SLOWEST))
        return np.asarray(np.maximum(least, _OF_A_PERIOD * period))

    def smearing(self, samples: slice) -> float:
        """Return the relative width over which lines are spread in a part because the angle was not measured [1]."""
        is_followed = self.has_encoder and (self.is_steady or np.isinf(self.pulses))
        if is_followed:
            return 0.0
        speed = self.speed[samples]
        mean = max(float(np.abs(speed).mean()), 1e-12)
        if self.pulses * mean * speed.size / self.rate < _FEWEST_PULSES * 2 * pi:
            return 1.0  # nobody knows how the shaft turned between two pulses
        changed = abs(float(speed[-1] - speed[0])) / max(speed.size - 1, 1) * self.rate
        late = 0.0 if self.is_steady else changed * float(self.time_error(np.array(mean))) / mean
        return late if self.has_encoder else UNMEASURED_ANGLE + late

    @property
    def is_steady(self) -> bool:
        """Whether the set-point of the speed was constant."""
        return self.run.profile == "steady"


def measured_runs(recordings: Sequence[Recording], rig: Rig) -> tuple[MeasuredRun, ...]:
    """Return the recordings with the angle of the motor: measured, or estimated from the torque or the set-point."""
    return tuple(
        _measured_run(recording, _directed(recording, angle), has_encoder=angle.measured, factor=angle.factor)
        for recording, angle in zip(recordings, shaft_angles(recordings, rig), strict=True)
    )


def _directed(recording: Recording, angle: ShaftAngle) -> Floats:
    """Return the angle; of a tacho, which does not show the direction, in that of the set-point."""
    if not angle.measured or _tacho_of(recording) is None or recording.run.speed is None:
        return angle.values
    set_point = set_point_profile(recording, "the direction of a tacho")
    return directed(angle.values, set_point)


def _tacho_of(recording: Recording) -> str | None:
    """Return the tacho that gives the angle; None where another channel does, or none."""
    return None if measured_motor_angle(recording) is not None else recording.find("tacho")


def _measured_run(recording: Recording, angle: Floats, *, has_encoder: bool, factor: float) -> MeasuredRun:
    """Return the run; an angle that was not measured is that of a constant speed where the set-point is constant.

    How the shaft sways about it is then the model's to tell, without the errors of an estimate.
    """
    run, rate = recording.run, recording.sample_rate
    if has_encoder and _tacho_of(recording) is not None:
        factor = abs(factor)
    held = replace(run, speed=None if run.speed is None else run.speed * factor)
    is_steady = run.profile == "steady"  # what an encoder scatters by is no change of the speed
    if is_steady and not has_encoder:
        angle = np.linspace(angle[0], angle[-1], angle.size)
    speed = speed_of(angle, rate, window=_WINDOW * recording.duration)
    course = np.full(speed.size, float(speed.mean())) if is_steady else speed
    blocks = blocks_of(course)
    if has_encoder and not is_steady:
        within = _between_pulses(recording)
        blocks = tuple(block for block in blocks if within(block)) or blocks
    pulses = _pulses(recording, angle) if has_encoder else float("inf")
    followed, noise = _followed(recording, speed, pulses) if has_encoder else (0.0, 0.0)
    return MeasuredRun(
        recording=replace(recording, run=held), torque=recording.torque(), angle=angle, speed=speed,
        has_encoder=has_encoder, speed_factor=factor, blocks=blocks, pulses=pulses,
        followed=followed, angle_noise=noise,
    )  # fmt: skip


def _pulses(recording: Recording, angle: Floats) -> float:
    """Return the pulses of a tacho per turn of the motor [1]; infinite where the angle comes from another channel."""
    tacho = _tacho_of(recording)
    if tacho is None:
        return float("inf")
    turns = float(np.abs(np.diff(angle)).sum()) / (2 * pi)
    return rising_edges(recording.channels[tacho].values).size / max(turns, 1e-9)


def _between_pulses(recording: Recording) -> Callable[[Block], bool]:
    """Return whether a block begins after the first pulse of a tacho and ends before the last one."""
    tacho = _tacho_of(recording)
    edges = np.zeros(0) if tacho is None else rising_edges(recording.channels[tacho].values)
    return lambda block: edges.size == 0 or bool(block.start >= edges[0] and block.stop <= edges[-1] + 1)


def _followed(recording: Recording, speed: Floats, pulses: float) -> tuple[float, float]:
    """Return up to which frequency a measured angle follows the shaft [Hz], and the density of its error [rad^2/Hz].

    The edges of a tacho are rounded to a sample: their times have the variance 1/12 of its square.
    """
    if np.isinf(pulses):
        return float("inf"), 0.0
    per_second = pulses * float(np.abs(speed).mean()) / (2 * pi)
    rounding = float(np.square(speed).mean()) / (12 * recording.sample_rate**2)
    return 0.5 * per_second, 2 * rounding / per_second
