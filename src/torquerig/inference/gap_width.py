"""The width of a gap, from how a torque rests near zero: a synthetic likelihood over simulated widths.

The statistics of each run have the mean and the variance of simulated replicates (Wood 2010, Nature 466), and an error
because law and damping of the contact and the parameters of the rig are not exact. The size of that error is one for
all statistics; it is estimated with the width, as all sizes of discrepancy are (Kennedy & O'Hagan 2001): rests that no
width explains well determine the width less.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.discrepancy import SPREAD
from torquerig.inference.likelihood import DEGREES_OF_FREEDOM
from torquerig.inference.prediction.gap_change import SimulatedRests

Floats = NDArray[np.float64]

_LAW = 0.1  # [1] prior median of the error of each statistic by the law of the contact and the parameters of the rig
_LAWS, _SIGMAS = 13, 3.0  # points of the grid of this error, and how far it goes [standard deviations of the logarithm]
_POINTS = 400  # of the grid of widths
_ENDS = (0.025, 0.5, 0.975)  # of the posterior: a 95 % interval and the median


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
    prior = _normal((at - np.log(median)) / spread)
    off = np.linspace(-_SIGMAS, _SIGMAS, _LAWS)
    laws, law_prior = _LAW * np.exp(SPREAD * off), _normal(off)
    density = sum((_densities(run, np.log(widths), at, laws) for run in runs), np.zeros((_LAWS, _POINTS + 1)))
    by_width = np.logaddexp.reduce(density + law_prior[:, None], axis=0)
    score, without = by_width[1:] + prior, float(by_width[0])
    evidence = float(np.logaddexp.reduce(score))
    share = np.exp(score - evidence)
    low, value, high = np.exp(np.interp(_ENDS, np.cumsum(share) - 0.5 * share, at)).tolist()
    return Width(value, low, high, evidence - without)


def _normal(position: Floats) -> Floats:
    """Return the logarithms of the probabilities of the points of a grid under a normal distribution."""
    density = -0.5 * np.square(position)
    return np.asarray(density - np.logaddexp.reduce(density))


def _densities(run: SimulatedRests, widths: Floats, at: Floats, laws: Floats) -> Floats:
    """Return the log-densities of the rests of a run, shape (laws, 1 + points): without a gap, and at each width."""
    count, mean = run.simulated.shape[0], run.simulated.mean(axis=0)
    expected = np.array([[none, *np.interp(at, widths, own)] for none, *own in mean.T])
    scatter = run.simulated.var(axis=0, ddof=1)[1:].mean(axis=0) * (1 + 1 / count)
    variance = (scatter + np.square(laws)[:, None])[:, :, None]
    square, nu = np.square(run.measured[:, None] - expected) / variance, DEGREES_OF_FREEDOM
    each = -0.5 * (nu + 1) * np.log1p(square / nu) - 0.5 * np.log(variance)
    return np.asarray(each.sum(axis=1))
