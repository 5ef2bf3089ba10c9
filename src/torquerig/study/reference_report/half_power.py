"""Half-power frequency of a torque signal, which the report compares between small and large particles."""

from __future__ import annotations

import numpy as np

from torquerig.recordings.recording import Recording


def half_power_frequency(reading: Recording, *, lowest: float = 0.5) -> float:
    """Return the frequency [Hz] below which half of the torque's power above ``lowest`` [Hz] lies."""
    torque = reading.torque()
    power = np.abs(np.fft.rfft(torque - torque.mean())) ** 2
    frequencies = np.arange(power.size) * reading.sample_rate / torque.size
    power[frequencies < lowest] = 0.0
    passed = np.cumsum(power)
    return float(frequencies[np.searchsorted(passed, 0.5 * passed[-1])])
