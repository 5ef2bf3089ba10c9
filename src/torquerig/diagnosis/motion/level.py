"""The speed at which a model's level is wrong, if it is anywhere."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import sqrt

import numpy as np

from torquerig.diagnosis.motion.evidence import root_mean_square, samples_that_count
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.moved import Moved

BINS = 12
_OUT = 6.0  # standard deviations of a bin's mean
TOLERANCE = 0.03  # of the rms effort: what nobody models


@dataclass(frozen=True, kw_only=True)
class LevelOff:
    """The bin of speed whose mean residual is furthest from zero: where, how far, and what all bins' means share.

    Parameters
    ----------
    at, width : float
        [rad/s] or [m/s].
    deviations : float
        Of the mean, in its standard deviations.
    share : float
        Of the residual's square, by the means of all bins [1].
    """

    at: float
    width: float
    deviations: float
    share: float


def level_off(model: FittedMotion, runs: Sequence[Moved]) -> LevelOff | None:
    """Return the worst bin of speed where chance and what nobody models cannot have moved the mean, or None."""
    left = model.of(runs)
    every, count = np.concatenate(left), samples_that_count(left)
    speed = np.concatenate([run.speed[run.seen] for run in runs])
    edges = np.quantile(speed, np.linspace(0, 1, BINS + 1))
    bins = [np.flatnonzero((speed >= low) & (speed <= high)) for low, high in pairwise(edges)]
    rows = [row for row in bins if row.size]
    means = np.array([every[row].mean() for row in rows])
    spreads = [every[row].std() / sqrt(max(row.size * count / every.size, 1.0)) + 1e-300 for row in rows]
    worst = int(np.argmax(np.abs(means)))
    out = float(abs(means[worst]) / spreads[worst])
    if out < _OUT or abs(means[worst]) < TOLERANCE * root_mean_square([run.effort[run.seen] for run in runs]):
        return None
    share = float((means**2 * np.array([row.size for row in rows])).sum() / (every @ every))
    here = speed[rows[worst]]
    return LevelOff(at=float(np.median(here)), width=float(np.ptp(here)), deviations=out, share=min(1.0, share))


def level_is_off(model: FittedMotion, runs: Sequence[Moved]) -> bool:
    """Whether a model's level is wrong at any speed."""
    return level_off(model, runs) is not None
