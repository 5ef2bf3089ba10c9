"""Monte Carlo sampling of a matrix: intervals of values, points and weights as arrays for the compiled kernel."""

from __future__ import annotations

from dataclasses import dataclass, replace
from hashlib import blake2b
from math import exp, isfinite, log
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.kesselring import TEACHING, Profile, points_of_cell, rated_criteria
from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.decide.criterion import Criterion
    from torquerig.decide.matrix import Cell, DecisionMatrix

Array = NDArray[np.float64]
WIDE = 5.0  # [1] high/low above which an interval is sampled log-uniformly, as the catalog does


@dataclass(frozen=True, kw_only=True)
class Uncertainty:
    """The uncertainty of the entries of a matrix; zero takes them as exact.

    Parameters
    ----------
    values : bool
        Whether values are sampled from their intervals, and the points of unknown cells from the whole scale.
    scores : float
        Half-width of the rating error of every cell's points [points].
    weights : float
        Half-width of the error of every raw weight, relative to it [1], 0 <= weights <= 1.
    """

    values: bool = True
    scores: float = 0.5
    weights: float = 0.25

    def __post_init__(self) -> None:
        if not isfinite(self.scores) or self.scores < 0:
            raise InputError(f"the uncertainty of scores, {self.scores:g} points, must be a number of at least 0")
        if not 0 <= self.weights <= 1:
            raise InputError(f"the uncertainty of weights, {self.weights:g}, must lie between 0 and 1; 0.25 is 25 %")


VALUES_ONLY = Uncertainty(scores=0.0, weights=0.0)


def separate_uncertainties(uncertainty: Uncertainty) -> dict[str, Uncertainty]:
    """Return each source of uncertainty alone, by name, and all of them together."""
    return {
        "intervals": replace(uncertainty, scores=0.0, weights=0.0),
        "scores": replace(uncertainty, values=False, weights=0.0),
        "weights": replace(uncertainty, values=False, scores=0.0),
        "together": uncertainty,
    }


@dataclass(frozen=True, kw_only=True)
class SamplingPlan:
    """A matrix as arrays that the compiled kernel samples.

    Parameters
    ----------
    cells, weights : tuples of ndarray
        In the form of :func:`torquerig.decide.kernel.count_ranks`.
    scale : ndarray, shape (2,)
    """

    alternatives: tuple[str, ...]
    profile: Profile
    cells: tuple[NDArray[Any], ...]
    weights: tuple[NDArray[Any], ...]
    scale: Array

    def with_errors(self, uncertainty: Uncertainty) -> SamplingPlan:
        """Return the plan with the errors of points and weights of ``uncertainty``; its values are sampled alike."""
        *cells, half_widths = self.cells
        raw, keys, _ = self.weights
        return replace(
            self, cells=(*cells, np.full(half_widths.shape, uncertainty.scores)),
            weights=(raw, keys, np.full(len(raw), uncertainty.weights)),
        )  # fmt: skip

    def totals(self, draws: int) -> Array:
        """Return T of each alternative in each of ``draws`` Monte Carlo samples, shape (alternatives, draws)."""
        from torquerig.decide.kernel import all_totals

        out = np.empty((len(self.alternatives), draws))
        all_totals(draws, self.cells, self.weights, self.scale, out)
        return out


def sampling_plan(
    matrix: DecisionMatrix, *, profile: Profile = TEACHING, uncertainty: Uncertainty = VALUES_ONLY, seed: int = 0
) -> SamplingPlan:
    """Return the random streams and intervals of every cell and weight.

    Each stream is keyed by seed and names, so that another alternative or criterion changes no sample of the others.
    Cells under one criterion that depend on the same fact share one stream, because that fact has one value.
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
            span = _span(cell, profile) if uncertainty.values else None
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
    return SamplingPlan(
        alternatives=matrix.alternatives,
        profile=profile,
        cells=(keys, start, width, logarithmic, base, slope, knots, turns, bends, np.full(shape, uncertainty.scores)),
        weights=(np.array([one.weight for one in rated]), weight_keys, np.full(len(rated), uncertainty.weights)),
        scale=np.array([profile.p_min, profile.p_max], dtype=float),
    )


def _span(cell: Cell, profile: Profile) -> tuple[float, float, bool] | None:
    """Return start and width of the sampled interval, and whether they are logarithms; None for an exact cell."""
    if cell.points_by_hand is not None:
        return None
    if cell.unknown:
        return profile.p_min, profile.p_max - profile.p_min, False
    low, high = cell.bounds
    if not low < high:
        return None
    return (log(low), log(high) - log(low), True) if 0 < low * WIDE < high else (low, high - low, False)


def value_at(cell: Cell, share: float) -> float:
    """Return the value below which ``share`` of the samples of an interval lie [unit of the criterion]."""
    low, high = cell.bounds
    if 0 < low * WIDE < high:
        return exp(log(low) + (log(high) - log(low)) * share)
    return low + (high - low) * share


def points_at(cell: Cell, criterion: Criterion, profile: Profile, share: float) -> float:
    """Return the points at that value; over the whole scale where the cell is unknown."""
    if cell.unknown or criterion.value is None:
        return profile.p_min + (profile.p_max - profile.p_min) * share
    return criterion.value.at(value_at(cell, share))


def points_over(cell: Cell, criterion: Criterion, profile: Profile, shares: Array) -> Array:
    """Return :func:`points_at` for many shares, same shape."""
    if cell.unknown or criterion.value is None:
        return profile.p_min + (profile.p_max - profile.p_min) * shares
    return criterion.value.over(values_over(cell, shares))


def values_over(cell: Cell, shares: Array) -> Array:
    """Return :func:`value_at` for many shares, same shape and digits."""
    low, high = cell.bounds
    if 0 < low * WIDE < high:
        return np.array([value_at(cell, share) for share in shares.tolist()])
    return low + (high - low) * shares


def _key(seed: int, *names: str) -> int:
    text = "\0".join((str(seed), *names))
    return int.from_bytes(blake2b(text.encode(), digest_size=8).digest(), "little")
