"""What a fit is worth when its residuals have a colour: how many of the samples count, and what a gain weighs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

PER_KNOB = 5.0  # what a further number must gain
LEAST_GAIN = 40.0  # what an effect must gain to be called missing


def samples_that_count(residuals: Sequence[Floats]) -> float:
    """Return how many independent samples the residuals are worth: each run's over its correlation time.

    The correlation time is ``1 + 2 sum of the autocorrelation`` up to its first zero (any text on Monte Carlo errors,
    for example Sokal 1997, Monte Carlo methods in statistical mechanics, section 3).
    """
    return float(sum(each.size / _correlation(each) for each in residuals))


def gained(before: Sequence[Floats], after: Sequence[Floats], *, numbers: int, count: float | None = None) -> float:
    """Return by how much twice the log likelihood grew, each further number paid for.

    ``count`` is how many samples count, the same for all hypotheses that are compared; without it, as ``after`` has it.
    """
    first, second = (float(sum(each @ each for each in one)) for one in (before, after))
    count = samples_that_count(after) if count is None else count
    return count * float(np.log(first / max(second, 1e-12 * first))) - PER_KNOB * numbers


def root_mean_square(residuals: Sequence[Floats]) -> float:
    """Return the rms over all residuals."""
    every = np.concatenate(list(residuals))
    return float(np.sqrt(np.mean(every**2)))


def _correlation(residual: Floats) -> float:
    count = residual.size
    spectrum = np.abs(np.fft.rfft(residual, 2 * count)) ** 2
    lags = np.fft.irfft(spectrum)[: count // 2]
    if not lags[0] > 0:
        return 1.0
    shares = lags / lags[0]
    below = np.flatnonzero(shares <= 0)
    reach = int(below[0]) if below.size else shares.size
    return max(1.0, 1.0 + 2.0 * float(shares[1:reach].sum()))
