"""Current for the required torque, and its share of the limits of motor and drive."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.open_data import over_intervals
from torquerig.metrics.sizing.required_torque import peak_torque
from torquerig.metrics.sizing.sized_drive import SizedDrive


def drive_current(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return ``rms_current``, ``peak_current``, ``limit_current`` [Arms] and their uses [1].

    Torque over the torque constant (per rms ampere of a phase); ``limit_current`` is that of the drive's torque limit
    as set. ``rms_current_use`` is over the rated current, ``peak_current_use`` over the limit, where Kt cancels. Kt is
    taken as constant: at peak torque the iron saturates and real currents are larger.
    """
    constant, rated = f"torque constant of {drive.motor_name}", f"rated current of {drive.motor_name}"
    data = {**drive.data, constant: drive.motor.torque_constant}
    limit = drive.part.torque_limit
    return {
        "rms_current": over_intervals(
            data, lambda v: drive.requirement(v).rms_torque / v[constant], unit="A", source="T / Kt"
        ),
        "peak_current": over_intervals(
            data, lambda v: peak_torque(drive.requirement(v)) / v[constant], unit="A", source="T / Kt"
        ),
        "limit_current": over_intervals(
            {constant: drive.motor.torque_constant},
            lambda v: limit / v[constant],
            unit="A",
            source="limit / Kt",
        ),
        "rms_current_use": over_intervals(
            {**data, rated: drive.motor.rated_current},
            lambda v: drive.requirement(v).rms_torque / v[constant] / v[rated],
            source="rms current / rated current",
        ),
        "peak_current_use": over_intervals(
            drive.data, lambda v: peak_torque(drive.requirement(v)) / limit, source="peak torque / drive's torque limit"
        ),
    }
