"""Curves of runs under measured motion: held-out pieces, a window, the level over the speed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.diagnosis.motion.evidence import root_mean_square
from torquerig.diagnosis.motion.level import TOLERANCE
from torquerig.diagnosis.motion.moved import Mask, Moved
from torquerig.diagnosis.showing.motion_comparison import MotionCompared

Floats = NDArray[np.float64]

_SWINGS = 12  # in a window: more are no longer seen one by one
_SHORTEST = 60  # samples of a window
_BINS = 25


@dataclass(frozen=True, eq=False)
class LevelOverSpeed:
    """What both models leave of the held-out effort on average, over the speed.

    Parameters
    ----------
    speed : ndarray, shape (bins,)
        Median of each bin [rad/s] or [m/s]; bins hold equally many samples.
    before, after : ndarray, shape (bins,)
        Mean of measured less foretold [N m] or [N].
    tolerance : float
        What nobody models [N m] or [N].
    """

    speed: Floats
    before: Floats
    after: Floats
    tolerance: float


def held_pieces(run: Moved) -> tuple[slice, ...]:
    """Return the samples that no fit has seen, stretch by stretch."""
    edges = np.flatnonzero(np.diff(run.held.astype(int), prepend=0, append=0))
    return tuple(slice(first, end) for first, end in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def telling_window(one: MotionCompared) -> slice:
    """Return a window of the held-out stretch that shows most: a dozen swings of what was found, or of what is left."""
    added = one.run.effort - one.before if one.alone else one.after - one.before
    piece = max(held_pieces(one.run), key=lambda each: float(added[each] @ added[each]))
    beside = added[piece] - added[piece].mean()
    swings = np.count_nonzero(np.diff(np.signbit(beside))) / 2
    length = piece.stop - piece.start
    size = length if swings <= _SWINGS else max(round(length * _SWINGS / swings), min(_SHORTEST, length))
    first = (piece.start + piece.stop - size) // 2
    return slice(first, first + size)


def level_over_speed(runs: Sequence[MotionCompared]) -> LevelOverSpeed:
    """Return what both models leave on average, in bins of speed of equally many held-out samples."""
    held = [one.run.held for one in runs]
    speed = _joined([one.run.speed for one in runs], held)
    before = _joined([one.run.effort - one.before for one in runs], held)
    after = _joined([one.run.effort - one.after for one in runs], held)
    rows = [row for row in np.array_split(np.argsort(speed, kind="stable"), _BINS) if row.size]
    effort = root_mean_square([one.run.effort[mask] for one, mask in zip(runs, held, strict=True)])
    return LevelOverSpeed(
        speed=np.array([np.median(speed[row]) for row in rows]), before=np.array([before[row].mean() for row in rows]),
        after=np.array([after[row].mean() for row in rows]), tolerance=TOLERANCE * effort,
    )  # fmt: skip


def _joined(values: Sequence[Floats], masks: Sequence[Mask]) -> Floats:
    return np.concatenate([each[mask] for each, mask in zip(values, masks, strict=True)])
