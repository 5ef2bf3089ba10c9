"""Use of the torque sensor: its range and its limit load, with and without the drive's limit."""

from __future__ import annotations

from collections.abc import Mapping

from torquerig.metrics.figure import Figure
from torquerig.metrics.sizing.gearbox_use import before_sensor
from torquerig.metrics.sizing.open_data import exact_value, over_intervals
from torquerig.metrics.sizing.sized_drive import SizedDrive
from torquerig.parameter import Estimate
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.parts import ForceSensor


def sensor_use(drive: SizedDrive) -> Mapping[str, Figure]:
    """Return shares of the sensor's range and limit load [1].

    ``sensor_cycle_use``: largest torque of the cycle over the range; ``sensor_range_use``: drive's limit x ratio x
    efficiency over the range; ``sensor_overload``: the same over the limit load (range x overload);
    ``sensor_overload_unlimited``: the motor's peak torque x ratio x efficiency over the limit load, without the
    drive's limit. All figures are static: the impact of the inertias in a jam at speed is not included.
    """
    sensor, motor = drive.sensor, drive.motor
    reach = _range(drive)
    stated = sensor.name if sensor else drive.rig.measured
    most, full = f"overload of {stated}", f"range of {stated}"
    known = {**drive.data, full: reach}
    limited = {**known, most: Estimate() if sensor is None else sensor.overload}
    peak = f"peak torque of {drive.motor_name}"
    return {
        "sensor_cycle_use": over_intervals(
            known, lambda v: before_sensor(drive, v).peak / v[full], source="largest torque of the cycle / range"
        ),
        "sensor_range_use": over_intervals(
            known, lambda v: drive.part.torque_limit * drive.gain(v) / v[full],
            source="drive's limit x ratio x efficiency / range",
        ),
        "sensor_overload": over_intervals(
            limited, lambda v: drive.part.torque_limit * drive.gain(v) / (v[full] * v[most]),
            source="drive's limit x ratio x efficiency / limit load",
        ),
        "sensor_overload_unlimited": over_intervals(
            {**limited, peak: motor.peak_torque}, lambda v: v[peak] * drive.gain(v) / (v[full] * v[most]),
            source="peak torque x ratio x efficiency / limit load",
        ),
    }  # fmt: skip


def _range(drive: SizedDrive) -> Estimate:
    """Return the sensor's range [N m], of a force sensor [N]: the catalog's, else that of its converter."""
    if drive.sensor is not None:
        return drive.sensor.range_torque
    part = drive.rig.part(drive.rig.measured)
    if isinstance(part, AmplifiedTorqueSensor | ForceSensor):
        return exact_value(part.converter_range / part.sensitivity)
    return Estimate()
