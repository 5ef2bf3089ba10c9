"""The effort that a recording states: which channel says what a motion took."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from torquerig.errors import RecordingError
from torquerig.recordings.recording import Channel, Recording

EFFORTS = ("torque", "force", "motor_torque")


def effort_of(recording: Recording) -> Channel:
    """Return the channel that is compared; RecordingError where there is none, or one with gaps."""
    name = next(_efforts_in(recording), None)
    if name is None:
        raise RecordingError(
            f"{recording.name}: there is no torque, force or motor_torque channel among "
            f"{', '.join(recording.channels)}; a current is one with its constant: {{quantity: motor_torque, unit: A, "
            "Nm_per_A: 0.1}"
        )
    channel = recording.channels[name]
    if not np.isfinite(channel.values).all():
        raise RecordingError(f"{recording.name}: {name} has gaps; cut the recording to a span without gaps")
    return channel


def _efforts_in(recording: Recording) -> Iterator[str]:
    """Yield the channels of effort: first the compared ones, and none that is an input or context."""
    for role in ("compared", None):
        for quantity in EFFORTS:
            for name, one in recording.channels.items():
                if one.quantity == quantity and one.role == role and not one.truth:
                    yield name
