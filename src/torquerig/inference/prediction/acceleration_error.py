"""How far the acceleration of the motor in each part is uncertain, where it comes from the pulses of a tacho.

An edge is known to a sample, so its angle has the variance ``(w / rate)^2 / 12`` at the speed w. With p pulses per
turn there are ``n = p w / 2 pi`` edges per second. Joined by straight lines they have noise of the density
``S = pi w / (3 p rate^2) sinc(f / n)^4``. The speed is the mean slope of the angle over a window W, the acceleration
the mean of two slopes of the speed by least squares, each over half a part, of the length h. A wave of the angle at the
frequency f is passed by

    ``-2 pi f sinc(f W) (6 / h) j1(pi f h) cos(pi f h)``,

j1 the spherical Bessel function; far below 1 / h that is ``-(2 pi f)^2``.

Source: Brown, Schneider & Mulligan 1992, IEEE Trans. Ind. Electron. 39 (speed from the times of pulses); Priestley
1981, *Spectral Analysis and Time Series*, 5.3 (variance of a linear functional of noise). Not valid for parts with less
than a pulse or so, whose acceleration nothing shows.
"""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.features.run_features import RunFeatures

Floats = NDArray[np.float64]

_HIGHEST = 4.0  # [1] over the window of the speed: what is faster has no part in an acceleration
_STILL = 1e-9  # [rad/s] keeps a quotient finite
_PER_PERIOD = 4.0  # points of the grid per inverse length of the recording


def acceleration_covariance(seen: RunFeatures) -> Floats | None:
    """Return the covariance of the mean acceleration in the parts [(rad/s^2)^2], shape (levels, levels).

    None where no tacho gives the angle, or the set-point is constant and the acceleration taken as 0.
    """
    run = seen.run
    if run.is_steady or np.isinf(run.pulses) or not seen.level.size:
        return None
    return seen.kept.get("acceleration error", None, lambda: _covariance(seen))


def _covariance(seen: RunFeatures) -> Floats:
    from scipy.special import spherical_jn

    run, half = seen.run, 0.5 * seen.level_duration[:, None]
    speed = np.abs(seen.level_speed).mean(axis=1)[:, None]
    step = 1 / (_PER_PERIOD * run.recording.duration)
    frequency = np.arange(0.0, _HIGHEST / run.window, step)[None]
    density = pi * speed / (3 * run.pulses * run.rate**2)
    edges = run.pulses * np.maximum(speed, _STILL) / (2 * pi)
    passed = 2 * pi * frequency * np.sinc(frequency * run.window) * 6 / half
    passed = passed * spherical_jn(1, pi * frequency * half) * np.cos(pi * frequency * half)
    passed = passed * np.sqrt(density * step) * np.sinc(frequency / edges) ** 2
    angle = 2 * pi * frequency * seen.level_time[:, None]
    both = np.concatenate([passed * np.cos(angle), passed * np.sin(angle)], axis=1)
    return np.asarray(both @ both.T)
