"""Kesselring rating: weighted points of each alternative, as an interval where data is missing.

Points come from absolute value functions, never from the other candidates: with column-sum or min-max scaling the
addition of a dominated alternative changes the winner in 4 to 7 % of random 4 x 6 cases (measured for the project);
here it cannot. Source: Kesselring 1951; VDI 2225 sheet 3 (1998), whose conformity is not claimed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.ranks import competition_ranks, rank_intervals
from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.decide.matrix import Cell, Criterion, DecisionMatrix

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Profile:
    """A points scale: from ``p_min`` (worst) to ``p_max`` (ideal), and when a rating counts as high.

    ``high`` is the T/T_max from which a result counts as high, so that a low cell in it is worth a warning; 0.6 is
    the textbook limit below which a rating is unsatisfactory. ``stated`` is False where a sheet states no scale: then
    sums and ranks are known, and T/T_max is not.
    """

    name: str
    p_min: float
    p_max: float
    high: float = 0.6
    stated: bool = True

    def refusal(self, points: float) -> str:
        """Return the error text for points outside the scale."""
        return (
            f"{points:g} points are outside the scale {self.p_min:g}..{self.p_max:g}; rescale them, or widen the scale"
        )

    def __post_init__(self) -> None:
        if not self.p_min < self.p_max or self.p_max <= 0:
            raise InputError(
                f"profile {self.name}: the scale {self.p_min:g}..{self.p_max:g} must run upwards to above 0"
            )

    @property
    def weak(self) -> float:
        """The most points that count as a weak spot: one step above the worst (1 on the scale 0-4)."""
        return self.p_min + 1


TEACHING = Profile(name="Scandinavian teaching variant, 1-5", p_min=1, p_max=5)
VDI_2225 = Profile(name="VDI 2225 scale, 0-4", p_min=0, p_max=4)


@dataclass(frozen=True, kw_only=True)
class WeakSpot:
    """A low cell that a high total hides."""

    alternative: str
    criterion: str
    points: float
    share: float


@dataclass(frozen=True, kw_only=True)
class KesselringResult:
    """Points, totals and ranks.

    Parameters
    ----------
    alternatives, criteria : tuple of str
        Only criteria with a positive weight.
    weights : ndarray, shape (criteria,)
        As given; see ``normalised``.
    low, high : ndarray, shape (alternatives, criteria)
        Fewest and most points that the cells allow; the whole scale where nothing is known.
    middle : ndarray, shape (alternatives, criteria)
        Points of the stated value, else the middle of low and high.
    by_hand : mapping of (alternative, criterion) to str
        The cells that were set by hand, with the reason.
    """

    profile: Profile
    alternatives: tuple[str, ...]
    criteria: tuple[str, ...]
    weights: Array
    low: Array
    high: Array
    middle: Array
    by_hand: Mapping[tuple[str, str], str] = field(default_factory=dict)

    @cached_property
    def normalised(self) -> Array:
        """The weights divided by their sum, shape (criteria,)."""
        return np.asarray(self.weights / self.weights.sum())

    @cached_property
    def weight_sum(self) -> float:
        """The sum of the raw weights; anything but 1 deserves a warning."""
        return float(self.weights.sum())

    @property
    def warning(self) -> str:
        """A sentence if the raw weights do not sum to 1, else empty; T/T_max does not depend on it."""
        if abs(self.weight_sum - 1) < 1e-9:
            return ""
        sums = f"the weights sum to {self.weight_sum:g}, not 1"
        return f"{sums}; compare T/T_max, which does not depend on the sum" if self.profile.stated else sums

    @cached_property
    def total_low(self) -> Array:
        """T with the lowest points of every unknown, shape (alternatives,)."""
        return _weighted(self.low, self.weights)

    @cached_property
    def total_high(self) -> Array:
        """T with the highest points of every unknown, shape (alternatives,)."""
        return _weighted(self.high, self.weights)

    @cached_property
    def total(self) -> Array:
        """T from the stated values and the middles of intervals, shape (alternatives,)."""
        return _weighted(self.middle, self.weights)

    @cached_property
    def ideal(self) -> float:
        """T of the ideal alternative, p_max everywhere."""
        return self.profile.p_max * self.weight_sum

    @cached_property
    def share(self) -> Array:
        """T/T_max, shape (alternatives,)."""
        return np.asarray(self.total / self.ideal)

    @cached_property
    def ranks(self) -> NDArray[np.int64]:
        """Shared competition ranks by ``total``, shape (alternatives,)."""
        return competition_ranks(self.total)

    @cached_property
    def rank_range(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The best and the worst rank that the total intervals allow."""
        return rank_intervals(self.total_low, self.total_high)

    @property
    def weak_spots(self) -> tuple[WeakSpot, ...]:
        """The cells with surely few points in alternatives whose T/T_max is high."""
        return tuple(
            WeakSpot(
                alternative=self.alternatives[row],
                criterion=self.criteria[column],
                points=float(self.high[row, column]),
                share=float(self.share[row]),
            )
            for row, column in np.argwhere(self.high <= self.profile.weak + 1e-9).tolist()
            if self.profile.stated and self.share[row] >= self.profile.high - 1e-9
        )


def kesselring(matrix: DecisionMatrix, *, profile: Profile = TEACHING) -> KesselringResult:
    """Return the weighted points of every alternative; a missing cell gives the whole scale, never zero.

    Raises
    ------
    InputError
        When no weight is positive, or a weighted criterion has no value function or one outside the scale.
    """
    rated = rated_criteria(matrix, profile)
    low, high, middle = (np.empty((len(matrix.alternatives), len(rated))) for _ in range(3))
    for column, criterion in enumerate(rated):
        for row, alternative in enumerate(matrix.alternatives):
            cell = matrix.cell(alternative, criterion.name)
            try:
                low[row, column], high[row, column], middle[row, column] = points_of_cell(cell, criterion, profile)
            except InputError as error:
                raise InputError(f"{alternative}, {criterion.name}: {error}") from None
    return KesselringResult(
        profile=profile,
        alternatives=matrix.alternatives,
        criteria=tuple(criterion.name for criterion in rated),
        weights=np.array([criterion.weight for criterion in rated]),
        low=low,
        high=high,
        middle=middle,
        by_hand={
            (alternative, criterion.name): cell.by_hand.reason
            for alternative in matrix.alternatives
            for criterion in rated
            if (cell := matrix.cell(alternative, criterion.name)).by_hand is not None
        },
    )


def kesselring_from_points(
    points: Mapping[str, Sequence[float | None]], *, weights: Mapping[str, float], profile: Profile = TEACHING
) -> KesselringResult:
    """Return the result of given points, ``points[alternative]`` in the order of ``weights``; None is unknown.

    Raises
    ------
    InputError
        When a weight is negative, all are zero, points lie outside the scale, or a row has the wrong length.
    """
    if any(weight < 0 for weight in weights.values()) or not any(weights.values()):
        raise InputError("the weights must be at least 0 and not all 0")
    for name, given in points.items():
        if len(given) != len(weights):
            raise InputError(f"{name}: points for {len(given)} of {len(weights)} criteria; write ? for an unknown one")
        for one in given:
            if one is not None and not profile.p_min <= one <= profile.p_max:
                raise InputError(f"{name}: {profile.refusal(one)}")
    known = np.array([[np.nan if one is None else one for one in given] for given in points.values()], dtype=float)
    low, high = np.where(np.isnan(known), profile.p_min, known), np.where(np.isnan(known), profile.p_max, known)
    return KesselringResult(
        profile=profile,
        alternatives=tuple(points),
        criteria=tuple(weights),
        weights=np.array(list(weights.values()), dtype=float),
        low=low,
        high=high,
        middle=(low + high) / 2,
    )


def rated_criteria(matrix: DecisionMatrix, profile: Profile) -> tuple[Criterion, ...]:
    """Return the criteria with a positive weight, each checked for points inside the scale of ``profile``."""
    rated = tuple(criterion for criterion in matrix.criteria if criterion.weight > 0)
    if not rated:
        raise InputError(f"{matrix.name}: all weights are 0; give at least one criterion a positive weight")
    for criterion in rated:
        if criterion.value is None:
            raise InputError(
                f"{criterion.name}: it has a weight but no value function; add points: [[value, points], ...]"
            )
        for _, points in criterion.value.knots:
            if not profile.p_min <= points <= profile.p_max:
                raise InputError(f"{criterion.name}: {profile.refusal(points)}")
    return rated


def _weighted(points: Array, weights: Array) -> Array:
    """Return the row sums; not a matrix product, whose last bits depend on how many rows there are."""
    return np.asarray((points * weights).sum(axis=1))


def points_of_cell(cell: Cell, criterion: Criterion, profile: Profile) -> tuple[float, float, float]:
    """Return the fewest, the most and the middle points of one cell; the whole scale where nothing is known."""
    if (given := cell.points_by_hand) is not None:
        if not profile.p_min <= given <= profile.p_max:
            raise InputError(f"{profile.refusal(given)}")
        return given, given, given
    if cell.unknown or criterion.value is None:
        return profile.p_min, profile.p_max, (profile.p_min + profile.p_max) / 2
    low, high = criterion.value.span(*cell.bounds)
    value = cell.used.value
    return low, high, (low + high) / 2 if value is None else criterion.value.at(value)
