"""Strength of each alternative: technical against economic rating, as in the S-diagram of VDI 2225.

Price belongs to the economic rating and not into the technical one. The formulas are textbook content on VDI 2225
sheet 3 (1998); conformity with the guideline is not claimed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.matrix import Cell
from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.decide.kesselring import KesselringResult

Array = NDArray[np.float64]
VERY_GOOD, GOOD, UNSATISFACTORY = 0.8, 0.7, 0.6
IDEAL_SHARE = 0.7  # [1] of the permissible cost, which counts as ideal


@dataclass(frozen=True, kw_only=True)
class Rating:
    """One of the two ratings, with the range due to open facts; arrays of shape (alternatives,) [1]."""

    value: Array
    low: Array
    high: Array

    @classmethod
    def of(cls, result: KesselringResult) -> Rating:
        """Return T/T_max of a Kesselring result: x = sum(g p) / (p_max sum(g))."""
        return cls(
            value=result.share,
            low=np.asarray(result.total_low / result.ideal),
            high=np.asarray(result.total_high / result.ideal),
        )


@dataclass(frozen=True, kw_only=True)
class Strength:
    """Both ratings together; the ideal is at (1, 1), and on the diagonal both ratings are equal.

    Parameters
    ----------
    alternatives : tuple of str
    technical, economic : Rating
    """

    alternatives: tuple[str, ...]
    technical: Rating
    economic: Rating

    @property
    def arithmetic(self) -> Array:
        """(x + y) / 2, shape (alternatives,)."""
        return np.asarray((self.technical.value + self.economic.value) / 2)

    @property
    def hyperbolic(self) -> Array:
        """sqrt(x y), shape (alternatives,): as the arithmetic mean on the diagonal, and less the further off it."""
        return np.asarray(np.sqrt(self.technical.value * self.economic.value))

    @property
    def hyperbolic_range(self) -> tuple[Array, Array]:
        """The lowest and highest sqrt(x y) for any value of the open facts."""
        x, y = self.technical, self.economic
        return np.sqrt(x.low * y.low), np.sqrt(x.high * y.high)

    def grades(self) -> tuple[str, ...]:
        """Return the guide value of each technical rating in words."""
        return tuple(grade(value) for value in self.technical.value.tolist())


def grade(rating: float) -> str:
    """Return the guide value of a rating in words: from 0.8 very good, from 0.7 good, below 0.6 unsatisfactory."""
    if rating >= VERY_GOOD:
        return "very good"
    if rating >= GOOD:
        return "good"
    return "fair" if rating >= UNSATISFACTORY else "unsatisfactory"


def strength(technical: KesselringResult, economic: KesselringResult) -> Strength:
    """Return both ratings from points."""
    if technical.alternatives != economic.alternatives:
        raise InputError("technical and economic rating must be of the same alternatives in the same order")
    return Strength(alternatives=technical.alternatives, technical=Rating.of(technical), economic=Rating.of(economic))


def strength_from_cost(technical: KesselringResult, costs: Mapping[str, Cell], *, permissible: float) -> Strength:
    """Return the technical rating together with y = H_ideal / H, H_ideal being 0.7 of the permissible cost.

    Parameters
    ----------
    costs : mapping of str to Cell
        The manufacturing or purchase cost H of each alternative, > 0; unknown ones leave y open from 0 to 1.
    permissible : float
        The highest cost that would be accepted [unit of the costs], > 0.

    Notes
    -----
    y is limited to 1: a cost below the ideal counts as ideal.
    """
    if not (isfinite(permissible) and permissible > 0):
        raise InputError(f"the permissible cost {permissible:g} must be above 0")
    rows = [_economic(name, costs.get(name, Cell()), IDEAL_SHARE * permissible) for name in technical.alternatives]
    value, low, high = (np.array(column) for column in zip(*rows, strict=True))
    economic = Rating(value=value, low=low, high=high)
    return Strength(alternatives=technical.alternatives, technical=Rating.of(technical), economic=economic)


def _economic(name: str, cost: Cell, ideal: float) -> tuple[float, float, float]:
    if cost.unknown:
        return 0.5, 0.0, 1.0
    low, high = cost.bounds
    if low < 0:
        raise InputError(f"{name}: a cost of {low:g} is below 0; write what it costs")
    y_low, y_high = (1.0 if one <= ideal else ideal / one for one in (high, low))
    value = cost.used.value
    y = (y_low + y_high) / 2 if value is None else (1.0 if value <= ideal else ideal / value)
    return y, y_low, y_high
