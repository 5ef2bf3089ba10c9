"""How long and how often the torque stays near zero: flanks that part leave the sensor without torque."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.looking.observed import Observed
from torquerig.recordings.repair.robust_spread import spread_about_zero

Floats = NDArray[np.float64]

_SMOOTHED = 4e-4  # [s] long against white noise, short against a stay
_NOISES = 4.0  # a torque within so many of its noise is none
_SHORTEST = 1e-3  # [s]
_SHARES = (0.5, 0.9, 0.99)
_SPREADS = np.array([0.15, 0.1, 0.15, 0.2, 0.3])  # of the logarithms


def near_zero_stays(observed: Observed) -> Floats:
    """Return the logarithms of number of stays per second, share of time, and length at three quantiles, shape (5,).

    Of the stretches that fits may see.
    """
    seen = observed.mask(held=False)
    width = max(1, int(_SMOOTHED * observed.rate))
    smooth = np.convolve(observed.torque, np.full(width, 1 / width), "same")
    noise = spread_about_zero(np.diff(observed.torque)) / np.sqrt(2)
    near = (np.abs(smooth) < _NOISES * noise) & seen
    edges = np.flatnonzero(np.diff(np.concatenate([[0], near.astype(int), [0]])))
    lengths = (edges[1::2] - edges[::2]) / observed.rate
    lengths = np.concatenate([lengths[lengths > _SHORTEST], [_SHORTEST]])
    duration = observed.torque.size / observed.rate
    numbers = [lengths.size / duration, float(lengths.sum()) / duration, *np.quantile(lengths, _SHARES)]
    return np.asarray(np.log(np.array(numbers)))


def near_zero_misfit(measured: Floats, model: Floats) -> Floats:
    """Return the residuals in units of how much two like runs differ, shape (5,)."""
    return np.asarray((measured - model) / _SPREADS)
