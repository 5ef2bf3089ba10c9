"""Course of the speed set-point before and during a recording."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from proof.rig_program import nominal
from proof.rig_program.plan import Profile, Run


def speed_course(
    run: Run, rng: np.random.Generator, *, speed_error: float, wanders: bool = True
) -> NDArray[np.float64]:
    """Return the motor's true set-point at every sample, settling included (n,) [rad/s].

    Time zero is the beginning of the recording; a ramp waits at a tenth of the set-point before it, a reversal is in
    full swing.
    """
    samples = round((nominal.SETTLING + run.duration) * nominal.SAMPLE_RATE)
    time = np.arange(samples) / nominal.SAMPLE_RATE - nominal.SETTLING
    top = run.motor_speed * (1.0 + speed_error)
    if run.profile is Profile.RAMP:
        return top * np.clip(0.1 + 0.9 * time / (0.9 * run.duration), 0.1, 1.0)
    if run.profile is Profile.REVERSAL:
        return top * np.sin(4.0 * np.pi * time / run.duration)
    return top * (1.0 + wander(rng, samples) * float(wanders))


def wander(rng: np.random.Generator, samples: int) -> NDArray[np.float64]:
    """Draw the slow relative wander of a steady speed (n,), made of slow noise at 50 Hz joined by straight lines."""
    sd, corner = nominal.WANDER
    step = nominal.SAMPLE_RATE / 50.0
    points = int(samples / step) + 2
    keep = np.exp(-2.0 * np.pi * corner / 50.0)
    course = np.empty(points)
    course[0] = rng.standard_normal()
    kicks = np.sqrt(1.0 - keep**2) * rng.standard_normal(points)
    for i in range(1, points):
        course[i] = keep * course[i - 1] + kicks[i]
    return np.asarray(sd * np.interp(np.arange(samples), step * np.arange(points), course))
