"""The motor's angle and mean speed from the best source that a recording has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.orders.angle.measured_angle import MotorAngle
from torquerig.orders.angle.speed_from_torque import motor_angle_from_torque
from torquerig.orders.angle.tacho import recorded_motor_angle

if TYPE_CHECKING:
    from torquerig.orders.kinematics.kinematic_lines import KinematicLine
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True)
class MotorSpeed:
    """The mean motor speed [rad/s], the relative half-width of its 95 % interval [1], and its source in words."""

    value: float
    half_width: float
    origin: str


def best_motor_angle(recording: Recording, lines: Sequence[KinematicLine], *, ratio: float | None = None) -> MotorAngle:
    """Return the motor's angle from the best source that the recording has; ``origin`` names the source.

    The sources in order of preference: an encoder or another angle or speed channel, the pulses of a tacho, the
    ``lines`` in the torque near the set-point, the set-point.

    Parameters
    ----------
    recording : Recording
    lines : sequence of KinematicLine
        The lines to search in the torque.
    ratio : float, optional
        Motor turns per output turn [1], for channels of the output shaft; by default that of the lines, or of the run.

    Raises
    ------
    RecordingError
        Where no source is usable.
    """
    ratio = _ratio(recording, lines) if ratio is None else ratio
    return recorded_motor_angle(recording, ratio=ratio) or motor_angle_from_torque(recording, lines)


def best_motor_speed(recording: Recording, lines: Sequence[KinematicLine]) -> MotorSpeed:
    """Return the mean motor speed by :func:`best_motor_angle`, with its 95 % interval."""
    angle = best_motor_angle(recording, lines)
    return MotorSpeed(abs(angle.mean_speed(recording.sample_rate)), angle.half_width, angle.origin)


def _ratio(recording: Recording, lines: Sequence[KinematicLine]) -> float:
    if lines:
        return lines[0].output_order / lines[0].motor_order
    return recording.run.gear_ratio or 1.0
