"""Torque that changes of the speed ask for: slow noise of a rig that no random load turns.

A set-point that moves by ``w`` rad/s makes the speed loop ask for the torque ``(kp + ki / s) / (1 + s lag) w`` on the
motor, which reaches the reading as every torque there does. Far below the loop's bandwidth that is inertia times
acceleration, and friction. Two things move it:

- a steady speed wanders, as noise through a second-order low-pass of the cutoff fc, of the relative rms ``a`` that the
  scenario states: ``S_w(f) = (a speed)^2 / (fc pi / 2^1.5) / (1 + (f / fc)^4)``, whose integral is ``(a speed)^2``;
- a profile bends, by the density S_a of its acceleration: ``S_w(f) = S_a(f) / (2 pi f)^2``.

Source: any text on servo drives; a supply has the slope of its torque over slip in place of kp. Not valid for the
steps of a digital set-point.
"""

from __future__ import annotations

from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures
from torquerig.inference.features.set_point_course import acceleration_density
from torquerig.linear_twin.twin import Twin

Floats = NDArray[np.float64]

_NOTHING = 1e-300


def wander_power(twin: Twin, seen: RunFeatures) -> Floats:
    """Return the density that a wandering speed makes [(N m)^2/Hz], on the grid of the shafts, shape (points,)."""
    run, grid = seen.run, twin.shafts.frequency
    if not (run.wander and run.is_steady):
        return np.zeros(grid.size)
    rms = run.wander * run.mean_speed
    wander = rms**2 / (run.wander_cutoff * pi / sqrt(8)) / (1 + (grid / run.wander_cutoff) ** 4)
    return _passed(twin, grid) * wander


def wander_between(twin: Twin, seen: RunFeatures) -> Floats:
    """Return the mean of that density in each band [(N m)^2/Hz], shape (bands,)."""
    grid, power = twin.shafts.frequency, wander_power(twin, seen)
    summed = np.concatenate([[0.0], np.cumsum(0.5 * (power[1:] + power[:-1]) * np.diff(grid))])
    low, high = seen.bands.low, seen.bands.high
    return np.asarray((np.interp(high, grid, summed) - np.interp(low, grid, summed)) / (high - low))


def wander_at(twin: Twin, seen: RunFeatures, frequency: Floats) -> Floats:
    """Return the same at other frequencies [Hz]."""
    logs = np.log(np.maximum(wander_power(twin, seen), _NOTHING))
    return np.asarray(np.exp(np.interp(np.log(frequency), np.log(twin.shafts.frequency), logs)))


def profile_density(twin: Twin, seen: RunFeatures) -> Floats:
    """Return the mean density that a profile makes in each segment [(N m)^2/Hz], shape (segments, bands)."""
    bent = seen.kept.get("bent", None, lambda: acceleration_density(seen.run, seen.segments))
    if not bent.any():
        return bent
    middle = seen.bands.middle
    return np.asarray(_passed(twin, middle) / (2 * pi * middle) ** 2 * bent)


def _passed(twin: Twin, frequency: Floats) -> Floats:
    """Return the square of the torque in the reading per speed of the set-point [(N m s/rad)^2] at frequencies [Hz]."""
    drive, s = twin.drives[0], 2j * pi * frequency
    loop = (drive.kp + drive.ki / s) / (1 + s * drive.lag)
    return np.asarray(np.abs(loop * twin.torque_on(drive.on, drive.against)(frequency)) ** 2)
