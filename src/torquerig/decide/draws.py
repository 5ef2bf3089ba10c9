"""What is drawn, and how far: the catalog's intervals, the points and the weights of a matrix as arrays of a kernel."""

from __future__ import annotations

from dataclasses import dataclass, replace
from hashlib import blake2b
from math import exp, isfinite, log
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.criterion import Criterion
from torquerig.decide.kesselring import TEACHING, Profile, points_of_cell, rated_criteria
from torquerig.decide.matrix import Cell, DecisionMatrix
from torquerig.errors import InputError

Array = NDArray[np.float64]
WIDE = 5.0  # [1] high/low above which an interval is drawn evenly in its logarithm, as the catalog's rule has it


@dataclass(frozen=True, kw_only=True)
class Doubt:
    """How far what was written down may be wrong; a zero keeps it as it is.

    Parameters
    ----------
    values : bool
        Whether values are drawn from their intervals, and unknown cells over the whole scale.
    scores : float
        Half-width of an error of judgement in every cell's points [points].
    weights : float
        Half-width of the error of every raw weight, as a share of it [1], 0 <= weights <= 1.
    """

    values: bool = True
    scores: float = 0.5
    weights: float = 0.25

    def __post_init__(self) -> None:
        if not isfinite(self.scores) or self.scores < 0:
            raise InputError(f"the doubt about scores, {self.scores:g} points, must be a number of at least 0")
        if not 0 <= self.weights <= 1:
            raise InputError(f"the doubt about weights, {self.weights:g}, must lie between 0 and 1; 0.25 is 25 %")


VALUES_ONLY = Doubt(scores=0.0, weights=0.0)


def sources(doubt: Doubt) -> dict[str, Doubt]:
    """Return each doubt on its own, by name, and all of them together."""
    return {
        "intervals": replace(doubt, scores=0.0, weights=0.0),
        "scores": replace(doubt, values=False, weights=0.0),
        "weights": replace(doubt, values=False, scores=0.0),
        "together": doubt,
    }


@dataclass(frozen=True, kw_only=True)
class Draws:
    """A matrix made ready to be drawn.

    Parameters
    ----------
    cells, weights : tuples of ndarray
        As :func:`torquerig.decide.kernel.count_ranks` wants them.
    scale : ndarray, shape (2,)
    """

    alternatives: tuple[str, ...]
    profile: Profile
    cells: tuple[NDArray[Any], ...]
    weights: tuple[NDArray[Any], ...]
    scale: Array

    def totals(self, draws: int) -> Array:
        """Return T of each alternative in each of ``draws`` joint draws, shape (alternatives, draws)."""
        from torquerig.decide.kernel import all_totals

        out = np.empty((len(self.alternatives), draws))
        all_totals(draws, self.cells, self.weights, self.scale, out)
        return out


def prepared(
    matrix: DecisionMatrix, *, profile: Profile = TEACHING, doubt: Doubt = VALUES_ONLY, seed: int = 0
) -> Draws:
    """Return the streams and intervals of every cell and weight.

    Each stream is keyed by seed and names, so that another alternative or criterion changes no draw of the others.
    Cells under one criterion that rest on the same fact have one stream: what is missing is missing once.
    """
    rated = rated_criteria(matrix, profile)
    shape = (len(matrix.alternatives), len(rated))
    most = max(len(criterion.value.knots) if criterion.value else 0 for criterion in rated)
    keys, logarithmic = np.empty(shape, np.uint64), np.zeros(shape, np.bool_)
    start, width, base, slope = (np.zeros(shape) for _ in range(4))
    knots, turns, bends = np.zeros((*shape, most)), np.zeros((*shape, most)), np.zeros(shape, np.int64)
    for row, alternative in enumerate(matrix.alternatives):
        for column, criterion in enumerate(rated):
            at, cell = (row, column), matrix.cell(alternative, criterion.name)
            keys[at] = _key(seed, "cell", cell.fact or alternative, criterion.name)
            span = _span(cell, profile) if doubt.values else None
            if span is None:
                base[at] = points_of_cell(cell, criterion, profile)[2]
                continue
            start[at], width[at], logarithmic[at] = span
            if cell.unknown or criterion.value is None:
                slope[at] = 1.0
                continue
            base[at], slope[at], inside = criterion.value.bends(*cell.bounds)
            bends[at] = len(inside)
            for bend, (knot, turn) in enumerate(inside):
                knots[row, column, bend], turns[row, column, bend] = knot, turn
    weight_keys = np.array([_key(seed, "weight", criterion.name) for criterion in rated], np.uint64)
    return Draws(
        alternatives=matrix.alternatives,
        profile=profile,
        cells=(keys, start, width, logarithmic, base, slope, knots, turns, bends, np.full(shape, doubt.scores)),
        weights=(np.array([one.weight for one in rated]), weight_keys, np.full(len(rated), doubt.weights)),
        scale=np.array([profile.p_min, profile.p_max], dtype=float),
    )


def _span(cell: Cell, profile: Profile) -> tuple[float, float, bool] | None:
    """Return start and width of what is drawn, and whether they are logarithms; None where nothing is open."""
    if cell.points_by_hand is not None:
        return None
    if cell.unknown:
        return profile.p_min, profile.p_max - profile.p_min, False
    low, high = cell.bounds
    if not low < high:
        return None
    return (log(low), log(high) - log(low), True) if 0 < low * WIDE < high else (low, high - low, False)


def value_at(cell: Cell, share: float) -> float:
    """Return the value below which ``share`` of the draws of an interval lie [unit of the criterion]."""
    low, high = cell.bounds
    if 0 < low * WIDE < high:
        return exp(log(low) + (log(high) - log(low)) * share)
    return low + (high - low) * share


def points_at(cell: Cell, criterion: Criterion, profile: Profile, share: float) -> float:
    """Return the points at that value; over the whole scale where the cell is unknown."""
    if cell.unknown or criterion.value is None:
        return profile.p_min + (profile.p_max - profile.p_min) * share
    return criterion.value.at(value_at(cell, share))


def _key(seed: int, *names: str) -> int:
    text = "\0".join((str(seed), *names))
    return int.from_bytes(blake2b(text.encode(), digest_size=8).digest(), "little")
