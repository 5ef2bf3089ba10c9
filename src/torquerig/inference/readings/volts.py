"""The compared channel as the sensor's output, in which data sheets state noise, zero, codes and limits."""

from __future__ import annotations

from dataclasses import replace

from torquerig.recordings.recording import Recording
from torquerig.rig.amplified_sensor import AmplifiedTorqueSensor
from torquerig.rig.assembly import Rig
from torquerig.units.table import UNITS


def in_volts(recording: Recording, rig: Rig) -> Recording:
    """Return a recording whose torque or force is in volts: of the stated sensitivity, where it is in another unit.

    A recording of a sensor without an amplifier is returned as it is. The torque in N m does not change.
    """
    sensor, name = rig.part(rig.measured), recording.torque_name()
    channel = recording.channels[name]
    if channel.unit == "V" or not isinstance(sensor, AmplifiedTorqueSensor):
        return recording
    volts = UNITS["voltage"].get(channel.unit) or abs(channel.si_per_unit) * sensor.sensitivity
    return recording.with_channel(
        name, replace(channel, values=channel.values * volts, unit="V", si_per_unit=channel.si_per_unit / volts)
    )
