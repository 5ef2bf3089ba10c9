"""A moment at which what a model leaves steps, and stays: a load or a zero that changed within the run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import log10

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.moved import STRETCHES, Moved

Floats = NDArray[np.float64]

_PIECES = 4 * STRETCHES  # of a run
_SHARE = 0.5  # of the pieces' squares that a step takes out, or no model is called wrong for it
_TOLERANCE = 0.05  # of the rms effort: what nobody models
_DRAWS = 1000
_FROM_ENDS = 4  # pieces: a step nearer to an end is one of a few of them
_CHANCE = 0.01


@dataclass(frozen=True, kw_only=True)
class Step:
    """A step of the mean.

    Parameters
    ----------
    run : str
    at, width : float
        Its moment, and how well that is known [s].
    height : float
        [N m] or [N].
    share, excess_db, p_value : float
        Of the square of the pieces' means [1]; over the rest of them; that pieces in another order share as much.
    """

    run: str
    at: float
    width: float
    height: float
    share: float
    excess_db: float
    p_value: float


def step_in(model: FittedMotion, runs: Sequence[Moved]) -> Step | None:
    """Return the largest step of a run's mean residual over pieces of a fortieth of it, or None.

    Chance is told by pieces put into another order: what comes and goes does not mind.
    """
    effort = root_mean_square([run.effort[run.seen] for run in runs if run.seen.any()])
    pairs = [(run, each) for run, each in zip(runs, model.residuals, strict=True) if run.seen.any()]
    found = [_of_run(run, each, effort, looked_at=len(pairs)) for run, each in pairs]
    return max((each for each in found if each is not None), key=lambda each: abs(each.height), default=None)


def _of_run(run: Moved, residual: Floats, effort: float, *, looked_at: int) -> Step | None:
    piece = np.arange(residual.size) * _PIECES // residual.size
    count = np.bincount(piece[run.seen], minlength=_PIECES)
    told = count > 0.5 * residual.size / _PIECES
    means = (np.bincount(piece[run.seen], weights=residual[run.seen], minlength=_PIECES) / np.maximum(count, 1))[told]
    middles = np.flatnonzero(told) + 0.5
    if means.size < 4 * _FROM_ENDS:
        return None
    share, cut = _stepped(means)
    height = float(means[cut:].mean() - means[:cut].mean())
    if share < _SHARE or abs(height) < _TOLERANCE * effort:
        return None
    rng = np.random.default_rng(0)
    chance = (1 + sum(_stepped(rng.permutation(means))[0] >= share for _ in range(_DRAWS))) / (1 + _DRAWS) * looked_at
    if chance > _CHANCE:
        return None
    second = residual.size / _PIECES / run.rate
    return Step(
        run=run.name, at=float(0.5 * (middles[cut - 1] + middles[cut])) * second,
        width=float(middles[cut] - middles[cut - 1]) * second, height=height, share=share,
        excess_db=10 * log10(share / max(1 - share, 1e-3)), p_value=chance,
    )  # fmt: skip


def _stepped(means: Floats) -> tuple[float, int]:
    """Return which share of the square a step takes out at best [1], and before which piece, not near an end."""
    apart = means - means.mean()
    sums, cuts = np.cumsum(apart)[:-1], np.arange(1, means.size)
    gained = sums**2 * means.size / (cuts * (means.size - cuts))
    cut = _FROM_ENDS + int(np.argmax(gained[_FROM_ENDS - 1 : 1 - _FROM_ENDS]))
    return float(gained[cut - 1] / max(float(apart @ apart), 1e-300)), cut
