"""Duty of a motor: mean square of its torque, and its speed, for each stretch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Recording
from torquerig.scenario.drive_requirement import DriveRequirement

Floats = NDArray[np.float64]
SHORTEST = 0.5  # [s] winding temperatures move in tens of seconds
STRETCHES = 200  # number of stretches of a long duty with a changing torque


@dataclass(frozen=True, kw_only=True)
class MotorDuty:
    """One cycle, or one recording. All arrays have the shape (stretches,).

    Parameters
    ----------
    duration : ndarray
        [s]
    torque_square : ndarray
        Mean square of the torque [(N m)^2].
    speed, speed_square : ndarray
        Mean of the absolute speed [rad/s], and of its square.
    peak_torque : float
        [N m]
    """

    duration: Floats
    torque_square: Floats
    speed: Floats
    speed_square: Floats
    peak_torque: float

    @property
    def length(self) -> float:
        """The duration [s]."""
        return float(self.duration.sum())

    @property
    def rms_torque(self) -> float:
        """Root of the mean square of the torque [N m]."""
        return float(np.sqrt(np.sum(self.torque_square * self.duration) / self.length))

    @property
    def mean_speed(self) -> float:
        """Mean of the absolute speed [rad/s]."""
        return float(np.sum(self.speed * self.duration) / self.length)


def duty_of_requirement(requirement: DriveRequirement) -> MotorDuty:
    """Return the duty of a required motion; pieces are cut or joined to stretches of ``grain`` [s].

    The mean squares of each stretch are exact. The heat is taken as constant within a stretch, which changes a
    temperature by less than the heat of half a stretch.
    """
    rows: list[tuple[float, float, float, float]] = []
    longest = grain(float(requirement.duration.sum()))
    for span, torque, speed in zip(requirement.duration, requirement.torque, requirement.speed, strict=True):
        even = torque[0] == torque[1] and speed[0] == speed[1]
        count = 1 if even else max(1, round(span / longest))
        ends = np.linspace(0.0, 1.0, count + 1)
        torques, speeds = (one[0] + ends * (one[1] - one[0]) for one in (torque, speed))
        for at in range(count):
            part = slice(at, at + 2)
            rows.append((float(span) / count, _mean_square(torques[part]), float(np.abs(speeds[part]).mean()),
                         _mean_square(speeds[part])))  # fmt: skip
    duration, torque_square, speeds, speed_square = _joined(np.array(rows), longest).T
    return MotorDuty(duration=duration, torque_square=torque_square, speed=speeds, speed_square=speed_square,
                     peak_torque=float(np.abs(requirement.torque).max()))  # fmt: skip


def grain(length: float) -> float:
    """Return the length of a stretch of changing torque, of a duty of ``length`` [s]."""
    return max(SHORTEST, length / STRETCHES)


def _joined(rows: Floats, shortest: float) -> Floats:
    """Return the rows (duration, means ...) with neighbours joined until they last ``shortest`` [s] or nearly so."""
    kept: list[Floats] = []
    for row in rows:
        if kept and kept[-1][0] + row[0] <= shortest * (1 + 1e-9):
            total = kept[-1][0] + row[0]
            kept[-1] = np.append(total, (kept[-1][0] * kept[-1][1:] + row[0] * row[1:]) / total)
        else:
            kept.append(row)
    return np.array(kept)


def duty_of_recording(recording: Recording) -> MotorDuty:
    """Return the duty of a recorded motor torque (true or measured), averaged over stretches of ``grain`` [s].

    Without a speed channel, the set-point of the run is used.

    Raises
    ------
    RecordingError
        When there is no motor torque, or neither a motor speed nor a set-point.
    """
    torque = _found(recording, "motor_torque")
    if torque is None:
        raise RecordingError(
            f"{recording.name}: there is no channel of motor torque; simulate with --truth, or record the drive's "
            "torque and name its quantity motor_torque in the sidecar"
        )
    speed = _found(recording, "motor_speed")
    if speed is None:
        if recording.run.speed is None:
            raise RecordingError(f"{recording.name}: there is neither a motor speed nor a set-point; add speed_rpm")
        speed = recording.run.speed_profile().speed(
            recording.time(), top=recording.run.speed, duration=recording.duration
        )
    starts = np.arange(0, recording.samples, max(1, round(grain(recording.duration) * recording.sample_rate)))
    counts = np.diff(np.append(starts, recording.samples))
    return MotorDuty(
        duration=counts / recording.sample_rate,
        torque_square=np.add.reduceat(torque**2, starts) / counts,
        speed=np.add.reduceat(np.abs(speed), starts) / counts,
        speed_square=np.add.reduceat(speed**2, starts) / counts,
        peak_torque=float(np.abs(torque).max()),
    )


def _found(recording: Recording, quantity: str) -> Floats | None:
    name = recording.find(quantity) or recording.find(quantity, truth=True)
    return None if name is None else recording.channels[name].in_si()


def _mean_square(ends: Floats) -> float:
    return float((ends[0] ** 2 + ends[0] * ends[1] + ends[1] ** 2) / 3)
