"""The width of a gap, from how a torque rests near zero: a synthetic likelihood over simulated widths.

The statistics of each run have the mean and the variance of simulated replicates (Wood 2010, Nature 466), with what the
law of the contact may change of them. Their likelihood is taken at each width, with a prior of the width.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.likelihood import DEGREES_OF_FREEDOM
from torquerig.inference.prediction.gap_change import SimulatedRests

Floats = NDArray[np.float64]

_LAW = 0.1  # [1] of each statistic: law and damping of the contact, and parameters of the rig, are not exact
_POINTS = 400  # of the grid of widths
_TWO_SIDED = 1.96


@dataclass(frozen=True)
class Width:
    """A width with the ends of its 95 % interval, and by how many nats the rests are more probable than without it."""

    value: float
    low: float
    high: float
    gain: float


def estimated_width(runs: Sequence[SimulatedRests], widths: Floats, *, median: float, spread: float) -> Width:
    """Return the width that the rests of all runs determine; ``median`` and ``spread`` are those of its prior.

    Parameters
    ----------
    widths : ndarray, shape (widths,)
        That were simulated, ascending.
    spread : float
        Standard deviation of the logarithm of the width [1].
    """
    at = np.linspace(np.log(widths[0]), np.log(widths[-1]), _POINTS)
    score, without = -0.5 * ((at - np.log(median)) / spread) ** 2, 0.0
    prior = np.logaddexp.reduce(score)
    for run in runs:
        count = run.simulated.shape[0]
        mean = run.simulated.mean(axis=0)
        variance = run.simulated.var(axis=0, ddof=1)[1:].mean(axis=0) * (1 + 1 / count) + _LAW**2
        expected = np.array([np.interp(at, np.log(widths), own) for own in mean[1:].T])
        score = score + _log_density((run.measured[:, None] - expected) / np.sqrt(variance)[:, None])
        without += float(_log_density((run.measured - mean[0]) / np.sqrt(variance)))
    share = np.exp(score - score.max())
    share /= share.sum()
    middle = float(share @ at)
    half = _TWO_SIDED * float(np.sqrt(share @ (at - middle) ** 2))
    low, value, high = np.exp([middle - half, middle, middle + half]).tolist()
    return Width(value, low, high, float(np.logaddexp.reduce(score) - prior) - without)


def _log_density(standardised: Floats) -> Floats:
    nu = DEGREES_OF_FREEDOM
    return np.asarray(-0.5 * (nu + 1) * np.log1p(standardised**2 / nu).sum(axis=0))
