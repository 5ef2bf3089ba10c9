"""Faults of the samples of one recording by itself, as ``info``, ``filter`` and ``ordermap`` print them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.detectors import examined
from torquerig.recordings.repair.faults import Fault

MEASURED = ("torque", "motor_torque", "force")
"""Quantities whose channels are examined."""
_ANGLES = ("motor_angle", "angle")


def recording_faults(recording: Recording) -> tuple[Fault, ...]:
    """Return what the detectors find in each measured torque or force of a recording.

    A run whose speed nobody states is no steady run for this: its steps and sweeps may be those of its motion.

    Parameters
    ----------
    recording : Recording
        All samples are numbers.
    """
    names = [name for name, one in recording.channels.items() if one.quantity in MEASURED and not one.truth]
    angles = {name: one for name, one in recording.channels.items() if one.quantity in _ANGLES and not one.truth}
    run = recording.run if recording.run.speed else replace(recording.run, profile="csv")
    told: list[Fault] = []
    for name in names:
        channel = recording.channels[name]
        if channel.values.size < 2 or not np.ptp(channel.values):
            continue
        alone = replace(recording, run=run, channels={name: replace(channel, quantity="torque", role=None), **angles})
        told += examined([alone]).faults
        angles = {}  # its jumps are found once
    return tuple(told)
