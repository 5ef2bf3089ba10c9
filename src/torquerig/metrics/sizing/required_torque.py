"""Torque, power and speed that the cycle requires of the motor."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.scenario.drive_requirement import DriveRequirement

SOURCE = "required by the profile, shafts rigid"


def torque_requirements(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``rms_torque`` and ``peak_torque`` [N m], ``peak_power`` [W], ``top_speed``, ``mean_speed`` [rad/s].

    The peak includes steps of the set-point, at which the drive is at its limit.
    """
    exact = drive.requirement()
    return {
        "rms_torque": over_intervals(drive.data, lambda v: drive.requirement(v).rms_torque, unit="N*m", source=SOURCE),
        "peak_torque": over_intervals(
            drive.data, lambda v: peak_torque(drive.requirement(v)), unit="N*m", source=SOURCE
        ),
        "peak_power": over_intervals(drive.data, lambda v: peak_power(drive.requirement(v)), unit="W", source=SOURCE),
        "top_speed": Figure(value=exact.top_speed, unit="rad/s", source=SOURCE),
        "mean_speed": Figure(value=mean_speed(exact), unit="rad/s", source=SOURCE),
    }


def use_of_ratings(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``rms_torque_use`` over the rated torque and ``peak_torque_use`` over the peak torque [1]."""
    rated, peak = f"rated torque of {drive.motor_name}", f"peak torque of {drive.motor_name}"
    return {
        "rms_torque_use": over_intervals(
            {**drive.data, rated: drive.motor.rated_torque}, lambda v: drive.requirement(v).rms_torque / v[rated],
            source="rms torque / rated torque",
        ),
        "peak_torque_use": over_intervals(
            {**drive.data, peak: drive.motor.peak_torque}, lambda v: peak_torque(drive.requirement(v)) / v[peak],
            source="largest torque / peak torque",
        ),
    }  # fmt: skip


def peak_torque(requirement: DriveRequirement) -> float:
    """Return the largest torque of either sign, steps included [N m]."""
    return float(np.abs(requirement.torque).max())


def peak_power(requirement: DriveRequirement) -> float:
    """Return the largest mechanical power at the motor's shaft [W]; exact within pieces."""
    first, last = requirement.torque[:, 0] * requirement.speed[:, 0], requirement.torque[:, 1] * requirement.speed[:, 1]
    rise_t, rise_w = np.diff(requirement.torque, axis=1)[:, 0], np.diff(requirement.speed, axis=1)[:, 0]
    bend = rise_t * rise_w
    slope = requirement.torque[:, 0] * rise_w + requirement.speed[:, 0] * rise_t
    with np.errstate(divide="ignore", invalid="ignore"):
        at = np.where(bend < 0, -slope / (2 * bend), 0.0)
    maximum = first + slope * np.clip(at, 0, 1) + bend * np.clip(at, 0, 1) ** 2
    return float(max(first.max(), last.max(), maximum.max()))


def mean_speed(requirement: DriveRequirement) -> float:
    """Return the mean of the absolute speed [rad/s]; no piece passes zero."""
    return float(np.sum(requirement.duration * np.abs(requirement.speed).mean(axis=1)) / np.sum(requirement.duration))
