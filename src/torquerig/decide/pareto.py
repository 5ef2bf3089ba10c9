"""Dominance and Pareto set: no worse in any criterion and better in at least one, without weights."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from torquerig.decide.matrix import DecisionMatrix

Flags = NDArray[np.bool_]


@dataclass(frozen=True, kw_only=True)
class Dominance:
    """Dominance of alternatives over each other, as far as the intervals determine it.

    Parameters
    ----------
    alternatives : tuple of str
    surely : ndarray of bool, shape (alternatives, alternatives)
        The row is at least as good in every criterion and better in one, for any value of the open facts.
    possibly : ndarray of bool, same shape
        There are values within the intervals for which it is.
    """

    alternatives: tuple[str, ...]
    surely: Flags
    possibly: Flags

    @property
    def efficient(self) -> tuple[str, ...]:
        """The certain members of the Pareto set: no alternative can dominate them."""
        return self._named(np.logical_not(self.possibly.any(axis=0)))

    @property
    def open(self) -> tuple[str, ...]:
        """The alternatives whose membership of the Pareto set depends on open facts."""
        return self._named(np.greater(self.possibly.any(axis=0), self.surely.any(axis=0)))

    @property
    def dominated(self) -> Mapping[str, tuple[str, ...]]:
        """Each certainly dominated alternative with those that dominate it."""
        names = np.array(self.alternatives)
        return {
            name: tuple(names[column].tolist())
            for name, column in zip(self.alternatives, self.surely.T, strict=True)
            if column.any()
        }

    def _named(self, flags: Flags | np.bool_) -> tuple[str, ...]:
        return tuple(name for name, flag in zip(self.alternatives, np.atleast_1d(flags), strict=True) if flag)


def dominance(matrix: DecisionMatrix) -> Dominance:
    """Compare all alternatives by value, without indifference bands, points or weights.

    Facts are taken as independent. Two alternatives that share an open fact may therefore be open although this fact
    does not distinguish them. With a wanted band, all values inside it are equal.
    """
    low, high = matrix.bounds
    count = len(matrix.alternatives)
    surely, possibly = np.ones((2, count, count), np.bool_)
    better, perhaps = np.zeros((2, count, count), np.bool_)
    for column, criterion in enumerate(matrix.criteria):
        poor, good = criterion.merit(low[:, column], high[:, column])
        poor, good = np.where(np.isnan(poor), -np.inf, poor), np.where(np.isnan(good), np.inf, good)
        surely &= poor[:, None] >= good[None, :]
        better |= poor[:, None] > good[None, :]
        possibly &= good[:, None] >= poor[None, :]
        perhaps |= good[:, None] > poor[None, :]
    others = ~np.eye(count, dtype=np.bool_)
    return Dominance(
        alternatives=matrix.alternatives, surely=surely & better & others, possibly=possibly & perhaps & others
    )
