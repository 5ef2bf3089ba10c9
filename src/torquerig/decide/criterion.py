"""Criteria of a matrix: direction, requirement, indifference band, and points on an absolute scale."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from itertools import pairwise
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

YES_NO = "yes/no"


class Better(StrEnum):
    """Which values are wanted."""

    MORE = "more"
    LESS = "less"
    BAND = "band"


class Kind(StrEnum):
    """The rating of VDI 2225 that a criterion belongs to; a price is economic."""

    TECHNICAL = "technical"
    ECONOMIC = "economic"


@dataclass(frozen=True, kw_only=True)
class Requirement:
    """A limit that must be met.

    Parameters
    ----------
    low, high : float or None
        The allowed range, ends included [unit of the criterion].
    in_question : str
        Why the limit itself must be checked; a failing alternative then gets ``!`` and is not eliminated.
    """

    low: float | None = None
    high: float | None = None
    in_question: str = ""

    def __post_init__(self) -> None:
        if self.low is None and self.high is None:
            raise InputError("a requirement needs a limit; write min or max, or leave the requirement out")
        if self.low is not None and self.high is not None and self.low > self.high:
            raise InputError(f"the requirement's min {self.low:g} is above its max {self.high:g}; swap them")

    def rule(self, name: str, unit: str) -> str:
        """Return the rule as a sentence part: ``price <= 600 EUR``."""
        if unit == YES_NO:
            return f"{name} must be {'yes' if self.low is not None and self.low > 0 else 'no'}"
        suffix = "" if unit == "1" else f" {unit}"
        if self.low is None:
            return f"{name} <= {self.high:g}{suffix}"
        if self.high is None:
            return f"{name} >= {self.low:g}{suffix}"
        return f"{self.low:g} <= {name} <= {self.high:g}{suffix}"


@dataclass(frozen=True, kw_only=True)
class Indifference:
    """How far two values may lie apart and still count as the same: the larger of both bands.

    Parameters
    ----------
    absolute : float
        Half-width [unit of the criterion], >= 0.
    relative : float
        Half-width as a share of the larger of the two magnitudes [1], 0 <= relative < 1. Taken so, "a beats b" and
        "b loses to a" are one statement, whichever of the two is the baseline.
    """

    absolute: float = 0.0
    relative: float = 0.0

    def __post_init__(self) -> None:
        if self.absolute < 0 or not isfinite(self.absolute):
            raise InputError(f"the indifference band {self.absolute:g} must be a number of at least 0")
        if not 0 <= self.relative < 1:
            raise InputError(f"the relative indifference band {self.relative:g} must be at least 0 and below 1")


@dataclass(frozen=True)
class ValueFunction:
    """Points as a function of the value: linear between knots, constant outside them.

    The points depend on the value alone and never on the other alternatives, so that adding or removing an
    alternative cannot reorder the rest.

    Parameters
    ----------
    knots : tuple of (value, points)
        Values ascending [unit of the criterion, points].
    """

    knots: tuple[tuple[float, float], ...]

    def __post_init__(self) -> None:
        if len(self.knots) < 2:
            raise InputError("a value function needs at least two (value, points) pairs")
        if not all(isfinite(number) for knot in self.knots for number in knot):
            raise InputError("a value function holds only finite numbers")
        for (left, _), (right, _) in pairwise(self.knots):
            if right <= left:
                raise InputError(f"the values of a value function must ascend; {right:g} follows {left:g}")

    def points(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the points of each value, same shape."""
        return np.interp(values, [value for value, _ in self.knots], [points for _, points in self.knots])

    def at(self, value: float) -> float:
        """Return the points of one value."""
        if value <= self.knots[0][0]:
            return self.knots[0][1]
        for (left, low), (right, high) in pairwise(self.knots):
            if value <= right:
                return low + (high - low) * (value - left) / (right - left)
        return self.knots[-1][1]

    def over(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return :meth:`at` for many values, same shape and digits."""
        found = np.full(values.shape, self.knots[-1][1], dtype=float)
        for (left, low), (right, high) in reversed(list(pairwise(self.knots))):
            below = values <= right
            found[below] = low + (high - low) * (values[below] - left) / (right - left)
        found[values <= self.knots[0][0]] = self.knots[0][1]
        return found

    def span(self, low: float, high: float) -> tuple[float, float]:
        """Return the fewest and the most points that a value between ``low`` and ``high`` may get."""
        candidates = [self.at(low), self.at(high), *(points for value, points in self.knots if low < value < high)]
        return min(candidates), max(candidates)

    def bends(self, low: float, high: float) -> tuple[float, float, tuple[tuple[float, float], ...]]:
        """Return the points between ``low`` and ``high`` as ``base + slope v + sum of turn max(0, v - knot)``.

        Returns
        -------
        base, slope : float
        bends : tuple of (knot, turn)
            Only the knots inside, with the change of slope there.
        """
        edges = [low, *(value for value, _ in self.knots if low < value < high), high]
        slopes = [(self.at(right) - self.at(left)) / (right - left) for left, right in pairwise(edges)]
        turns = tuple(
            (edge, after - before) for edge, (before, after) in zip(edges[1:], pairwise(slopes), strict=False)
        )
        return self.at(low) - slopes[0] * low, slopes[0], turns

    def check(self, better: Better) -> None:
        """Raise InputError where the points are not monotone in the direction of ``better``."""
        steps = [(left, right[1] - left[1], right) for left, right in pairwise(self.knots)]
        fell = False
        for left, step, right in steps:
            wrong = (better is Better.MORE and step < 0) or (better is Better.LESS and step > 0) or (fell and step > 0)
            if wrong:
                wanted = {
                    Better.MORE: "more is better, so the points may not fall",
                    Better.LESS: "less is better, so the points may not rise",
                    Better.BAND: "a band is best, so the points may not rise again after they fell",
                }[better]
                raise InputError(
                    f"the value function is not monotone: from {left[0]:g} to {right[0]:g} the points go from "
                    f"{left[1]:g} to {right[1]:g}; {wanted}"
                )
            fell = fell or (better is Better.BAND and step < 0)


@dataclass(frozen=True, kw_only=True)
class Criterion:
    """One row of a matrix.

    Parameters
    ----------
    name : str
        Worded as a merit or with its direction plain.
    unit : str
        The unit in which cells, limits and knots are written; ``1`` for a bare number, ``yes/no`` for 1 and 0.
    better : Better
        ``MORE``, ``LESS``, or ``BAND`` with ``band`` the wanted range.
    band : (float, float) or None
        The wanted range [unit], only with ``BAND``.
    requirement : Requirement or None
        The limit that must be met; None makes the criterion a wish, and a wish never eliminates.
    indifference : Indifference
        When two values count as the same (Pugh).
    value : ValueFunction or None
        The points of a value (Kesselring); needed where ``weight`` is positive.
    weight : float
        Raw weight [1], >= 0; 0 leaves the criterion out of Kesselring.
    kind : Kind
        Technical or economic.
    purpose : str
        The reason for the criterion.
    """

    name: str
    unit: str = "1"
    better: Better = Better.MORE
    band: tuple[float, float] | None = None
    requirement: Requirement | None = None
    indifference: Indifference = field(default_factory=Indifference)
    value: ValueFunction | None = None
    weight: float = 0.0
    kind: Kind = Kind.TECHNICAL
    purpose: str = ""

    def __post_init__(self) -> None:
        if not isfinite(self.weight) or self.weight < 0:
            raise InputError(f"{self.name}: the weight {self.weight:g} must be at least 0; turn the criterion round")
        if (self.better is Better.BAND) != (self.band is not None):
            raise InputError(f"{self.name}: band limits and better: band belong together; write both or neither")
        if self.band is not None and self.band[0] > self.band[1]:
            raise InputError(
                f"{self.name}: the band's lower limit {self.band[0]:g} is above {self.band[1]:g}; swap them"
            )
        if self.value is not None:
            try:
                self.value.check(self.better)
            except InputError as error:
                raise InputError(f"{self.name}: {error}") from None

    @property
    def wish(self) -> bool:
        """Whether there is no requirement, so that the criterion may rank but never eliminate."""
        return self.requirement is None

    def merit(
        self, low: NDArray[np.float64], high: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the values turned so that more is better, as ends of intervals [unit]; NaN stays NaN.

        For a band the merit is minus the distance from the band, 0 inside it.
        """
        if self.better is Better.MORE:
            return low, high
        if self.better is Better.LESS or self.band is None:
            return -high, -low
        at_low, at_high = (-np.maximum(0, np.maximum(self.band[0] - end, end - self.band[1])) for end in (low, high))
        touches = (low <= self.band[1]) & (high >= self.band[0])
        return np.minimum(at_low, at_high), np.where(touches, 0.0, np.maximum(at_low, at_high))
