"""What of a model's residual comes again whenever the motion passes a place the same way: a loop that it lacks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.fitted import FittedMotion
from torquerig.diagnosis.motion.lines import moving
from torquerig.diagnosis.motion.moved import STRETCHES, Moved

Floats = NDArray[np.float64]

PLACES = 8  # of the stroke, each passed both ways
_SHARE = 0.2  # of the residual's square that comes again, or no model is called wrong for it
_TOLERANCE = 0.05  # of the rms effort: what nobody models
_DRAWS = 400
_CHANCE = 0.01


@dataclass(frozen=True, kw_only=True)
class CourseLeft:
    """Where the mean residual is largest, and what comes again.

    Parameters
    ----------
    at, width : float
        A part of the stroke [rad] or [m].
    share : float
        Of the residual's square, in stretches that the means were not taken of [1].
    excess_db : float
        Of what comes again over what does not.
    p_value : float
        That stretches of random sign share as much.
    runs : tuple of str
    """

    at: float
    width: float
    share: float
    excess_db: float
    p_value: float
    runs: tuple[str, ...]


@dataclass(frozen=True)
class _Sums:
    """Sums of one run's residual by stretch and cell, how many samples make them, and the middles of the places."""

    sums: Floats
    counts: Floats
    middles: Floats
    square: float


def course_left(model: FittedMotion, runs: Sequence[Moved]) -> CourseLeft | None:
    """Return the course that every other stretch of the runs foretells in those between, or None.

    Chance is told by giving each stretch a sign of its own: what does not come again does not mind.
    """
    pairs = [(run, each) for run, each in zip(runs, model.residuals, strict=True) if run.seen.any()]
    summed = [_summed(run, each) for run, each in pairs]
    share = _foretold(summed, [np.ones(len(each.sums)) for each in summed])
    left = root_mean_square(model.of(runs))
    effort = root_mean_square([run.effort[run.seen] for run, _ in pairs])
    if share < _SHARE or np.sqrt(share) * left < _TOLERANCE * effort:
        return None
    rng = np.random.default_rng(0)
    drawn = [_foretold(summed, [rng.choice([-1.0, 1.0], len(each.sums)) for each in summed]) for _ in range(_DRAWS)]
    chance = (1 + sum(other >= share for other in drawn)) / (1 + _DRAWS)
    if chance > _CHANCE:
        return None
    whole = [each.sums.sum(axis=0) / np.maximum(each.counts.sum(axis=0), 1) for each in summed]
    worst = int(np.argmax([np.abs(means).max() for means in whole]))
    middles = summed[worst].middles
    return CourseLeft(
        at=float(middles[int(np.argmax(np.abs(whole[worst]))) % PLACES]), width=float(middles[1] - middles[0]),
        share=share, excess_db=float(10 * np.log10(share / max(1 - share, 1e-3))), p_value=chance,
        runs=tuple(run.name for run, _ in pairs),
    )  # fmt: skip


def _summed(run: Moved, residual: Floats) -> _Sums:
    kept = np.flatnonzero(run.seen & moving(run))
    edges = np.linspace(float(run.position[kept].min()), float(run.position[kept].max()), PLACES + 1)
    place = np.clip(np.searchsorted(edges, run.position[kept], side="right") - 1, 0, PLACES - 1)
    cell = place + PLACES * (run.speed[kept] > 0)
    stretch = kept * 4 * STRETCHES // residual.size
    index = (stretch, cell)
    sums, counts = np.zeros((4 * STRETCHES, 2 * PLACES)), np.zeros((4 * STRETCHES, 2 * PLACES))
    np.add.at(sums, index, residual[kept])
    np.add.at(counts, index, 1.0)
    return _Sums(sums, counts, 0.5 * (edges[1:] + edges[:-1]), float(residual[kept] @ residual[kept]))


def _foretold(summed: Sequence[_Sums], signs: Sequence[Floats]) -> float:
    """Return which share of the squares the means of the cells foretell, each stretch by those of all others [1]."""
    gained = 0.0
    for each, sign in zip(summed, signs, strict=True):
        sums = each.sums * sign[:, None]
        other, count = sums.sum(axis=0) - sums, each.counts.sum(axis=0) - each.counts
        means = other / np.maximum(count, 1)
        gained += float((2 * means * sums - means**2 * each.counts).sum())
    return gained / max(sum(each.square for each in summed), 1e-300)
