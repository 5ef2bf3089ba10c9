"""The set-point of the motor speed over time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.signals.coloured_noise import low_passed_noise
from torquerig.signals.run import Run


def set_point(
    run: Run, *, settling: int, samples: int, rate: float, wander: float, rng: np.random.Generator
) -> NDArray[np.float64]:
    """Return the set-point [rad/s] at every sample of settling and recording and one more, shape (settling+samples+1,).

    While settling, the profile stands at its first value. A steady run wanders slowly: noise through a low-pass of
    0.3 Hz, of relative rms ``wander``.
    """
    speed = run.speed or 0.0
    time = np.maximum(0, np.arange(-settling, samples + 1)) / max(1, samples)  # 0..1 over the recording
    if run.profile == "ramp":
        return np.asarray(speed * np.minimum(1.0, 0.1 + 0.9 * time / 0.9))
    if run.profile == "reversal":
        return np.asarray(speed * np.sin(4 * np.pi * time))
    if wander == 0:
        return np.full(time.size, speed)
    return np.asarray(speed * (1 + wander * low_passed_noise(time.size, rate, 0.3, rng)))
