"""The set-point of the motor speed that the test conditions state, once and at each sample."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import RecordingError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from torquerig.recordings.recording import Recording


def set_point_speed(recording: Recording, purpose: str) -> float:
    """Return the set-point of the motor speed [rad/s]; RecordingError, naming ``purpose``, where there is none."""
    speed = recording.run.speed
    if speed is None or speed == 0:
        raise RecordingError(
            f"{recording.name}: the run states no motor speed, and {purpose} need one; "
            "add to the sidecar: run: {speed_rpm: 1000}"
        )
    return speed


def set_point_profile(recording: Recording, purpose: str) -> NDArray[np.float64]:
    """Return the set-point of the motor speed at each sample [rad/s], shape (samples,), by the run's profile.

    The stated profile is stretched over the length of the recording (``recordings/profiles``).
    """
    speed = set_point_speed(recording, purpose)
    return recording.run.speed_profile().speed(recording.time(), top=speed, duration=recording.duration)
