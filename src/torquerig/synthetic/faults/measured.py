"""What faults disturb: the measured channels, the torque in N m, the angle of an encoder, rows and their times."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.quantities import OTHER
from torquerig.recordings.recording import Channel, Recording

STAMPS, SAMPLE_NUMBER = "stamps_s", "true_sample_number"
"""Channels of the times that a file states for its rows [s], and of the sample that a row is."""

Floats = NDArray[np.float64]


def is_measured(channel: Channel) -> bool:
    """Return whether a channel is a reading of a sensor."""
    return not channel.truth and channel.quantity != "time"


def measured_names(recording: Recording) -> list[str]:
    """Return the names of all readings."""
    return [name for name, one in recording.channels.items() if is_measured(one)]


def with_added_torque(recording: Recording, torque: Floats) -> Recording:
    """Return the recording with ``torque`` [N m], shape (samples,), added to its reading; as it is where that is 0."""
    name = recording.torque_name()
    channel = recording.channels[name]
    return recording.with_values(name, channel.values + torque / channel.si_per_unit)


def angle_name(recording: Recording, *, fault: str) -> str:
    """Return the channel of the measured angle; InputError where there is none."""
    name = recording.find("motor_angle") or recording.find("angle")
    if name is None:
        raise InputError(
            f"{recording.name}: {fault} disturbs the angle of an encoder, and there is none; use a recording with a "
            "channel of quantity motor_angle, or a mixture with counts_per_rev: 4096"
        )
    return name


def counts_name(recording: Recording, *, fault: str) -> str:
    """Return the channel of the counts of an encoder; InputError where the angle is not in counts."""
    name = angle_name(recording, fault=fault)
    unit = recording.channels[name].unit
    if unit != "count":
        raise InputError(
            f"{recording.name}: {fault} disturbs the counts of an encoder, and {name} is in {unit}; use a recording "
            "with an angle in counts"
        )
    return name


def with_stamps(recording: Recording) -> Recording:
    """Return the recording with the times and the numbers of its rows, where it does not have them yet."""
    if STAMPS in recording.channels:
        return recording
    numbers = Channel(values=np.arange(recording.samples, dtype=np.float64), quantity=OTHER, unit="1", truth=True)
    stamps = Channel(values=recording.time(), quantity="time", unit="s")
    return recording.with_channel(STAMPS, stamps).with_channel(SAMPLE_NUMBER, numbers)


def rows(recording: Recording, numbers: NDArray[np.int_], names: Iterable[str] | None = None) -> Recording:
    """Return the recording with the rows ``numbers`` of all channels, or of the channels ``names`` alone."""
    chosen = set(recording.channels if names is None else names)
    channels = {
        name: replace(one, values=one.values[numbers]) if name in chosen else one
        for name, one in recording.channels.items()
    }
    return replace(recording, channels=channels)
