"""Rounded dropouts of several recordings are found together, and a diagnosis takes them for a loss of signal."""

from __future__ import annotations

import numpy as np
from scipy.signal import butter, sosfilt

from torquerig.recordings.recording import Recording

LENGTH, LOW_PASS = 0.006, 200.0  # [s], [Hz]
AT = ((0.7, 2.3, 4.9), (1.1, 3.2, 5.5))  # [s] in either run: too few in one alone


def lost(recording: Recording, starts: tuple[float, ...]) -> Recording:
    """Return the recording at 0 V from each moment on for a while, behind a low-pass, with noise of the converter."""
    rate, volts = recording.sample_rate, recording.torque_values().copy()
    for start in starts:
        volts[round(start * rate) : round((start + LENGTH) * rate)] = 0.0
    behind = sosfilt(butter(2, LOW_PASS, fs=rate, output="sos"), volts - volts[0]) + volts[0]
    noise = 0.005 * np.random.default_rng(1).standard_normal(volts.size)
    return recording.with_values(recording.torque_name(), behind + noise)
