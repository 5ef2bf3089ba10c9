"""Pugh matrix: each alternative is better (+), worse (-) or the same (S) as a baseline, under each criterion.

Marks of people may be graded: ``++`` and ``--`` count 2 and -2 in the net, and as one better or worse in the counts.

Pugh calls the baseline the datum. Signs come from values, so that a new baseline needs no new rating. Pugh counts
``+``, ``-`` and ``S`` separately; the net of pluses and minuses comes from concept screening and is an option here.
Source: Pugh, Concept selection - a method that works, ICED 1981; net score: Ulrich and Eppinger, Product Design and
Development, concept screening. One baseline is not enough: in random 5 x 6 cases the net winner differs between
baselines in 84 % (measured for the project).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.ranks import competition_ranks, rank_intervals
from torquerig.errors import InputError, UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from torquerig.decide.matrix import Criterion, DecisionMatrix

Signs = NDArray[np.int8]


class Sign(StrEnum):
    """How an alternative compares with the baseline under one criterion."""

    BETTER = "+"
    WORSE = "-"
    SAME = "S"
    UNKNOWN = "?"


_RANGE = {Sign.BETTER: (1, 1), Sign.WORSE: (-1, -1), Sign.SAME: (0, 0), Sign.UNKNOWN: (-1, 1)}
_CERTAIN = {1: Sign.BETTER, -1: Sign.WORSE, 0: Sign.SAME}


@dataclass(frozen=True, kw_only=True)
class PughResult:
    """Signs of all alternatives against one baseline, which is one of them and has ``S`` everywhere.

    Parameters
    ----------
    baseline : str
    alternatives, criteria : tuple of str
    low, high : ndarray of int8, shape (alternatives, criteria)
        The worst and the best sign (-1, 0, +1; -2 to 2 where graded) that the cells allow; where they differ the sign
        is ``?``.
    """

    baseline: str
    alternatives: tuple[str, ...]
    criteria: tuple[str, ...]
    low: Signs
    high: Signs

    def signs(self, alternative: str) -> tuple[Sign, ...]:
        """Return the signs of one alternative, one per criterion."""
        row = self.alternatives.index(alternative)
        pairs = zip(self.low[row].tolist(), self.high[row].tolist(), strict=True)
        return tuple(_CERTAIN[(low > 0) - (low < 0)] if low == high else Sign.UNKNOWN for low, high in pairs)

    def counts(self, alternative: str) -> Mapping[Sign, int]:
        """Return how many ``+``, ``-``, ``S`` and ``?`` one alternative has: the result as Pugh defines it."""
        signs = self.signs(alternative)
        return {sign: signs.count(sign) for sign in Sign}

    @cached_property
    def net_low(self) -> NDArray[np.int64]:
        """The net of pluses and minuses if every ``?`` is ``-``, shape (alternatives,)."""
        return np.asarray(self.low.sum(axis=1), dtype=np.int64)

    @cached_property
    def net_high(self) -> NDArray[np.int64]:
        """The net of pluses and minuses if every ``?`` is ``+``, shape (alternatives,)."""
        return np.asarray(self.high.sum(axis=1), dtype=np.int64)

    @cached_property
    def net_certain(self) -> NDArray[np.int64]:
        """Pluses minus minuses with every ``?`` left out, as published tables add up; shape (alternatives,)."""
        return np.asarray(np.where(self.low == self.high, self.low, 0).sum(axis=1), dtype=np.int64)

    @property
    def ranks(self) -> NDArray[np.int64]:
        """Shared competition ranks by ``net_certain``, the baseline included; shape (alternatives,)."""
        return competition_ranks(self.net_certain)

    @property
    def rank_range(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The best and the worst rank that the net intervals allow; the baseline included."""
        return rank_intervals(self.net_low, self.net_high)


def pugh(matrix: DecisionMatrix, baseline: str) -> PughResult:
    """Compare every alternative of ``matrix`` with ``baseline``; intervals give a sign only where it is certain.

    Raises
    ------
    UnknownNameError
        When the baseline is not in the matrix.
    """
    place = matrix.index(baseline)
    low, high = _signs_against(matrix, np.array([place]))
    return PughResult(
        baseline=baseline,
        alternatives=matrix.alternatives,
        criteria=tuple(criterion.name for criterion in matrix.criteria),
        low=low[:, 0],
        high=high[:, 0],
    )


def pugh_from_signs(signs: Mapping[str, Sequence[Sign]], *, baseline: str, criteria: Sequence[str]) -> PughResult:
    """Add up given signs; the baseline may be left out of ``signs`` and is ``S`` by construction.

    Raises
    ------
    InputError
        When a row has another number of signs than there are criteria, or the baseline has another sign than ``S``.
    """
    for name, given in signs.items():
        if len(given) != len(criteria):
            raise InputError(f"{name}: {len(given)} signs for {len(criteria)} criteria; give one for each")
    if any(sign is not Sign.SAME for sign in signs.get(baseline, ())):
        raise InputError(f"{baseline}: the baseline is S against itself; leave its signs out")
    ranges = {name: [_RANGE[sign] for sign in given] for name, given in signs.items()}
    return pugh_from_levels(ranges, baseline=baseline, criteria=criteria)


def pugh_from_levels(
    levels: Mapping[str, Sequence[tuple[int, int]]], *, baseline: str, criteria: Sequence[str]
) -> PughResult:
    """Add up graded signs, each as its lowest and highest level from -2 to 2; the baseline has 0 and may be absent."""
    full = {baseline: [(0, 0)] * len(criteria), **levels}
    ends = np.array([list(given) for given in full.values()], dtype=np.int8)
    ends = ends.reshape(len(full), len(criteria), 2)
    return PughResult(
        baseline=baseline, alternatives=tuple(full), criteria=tuple(criteria), low=ends[..., 0], high=ends[..., 1]
    )


@dataclass(frozen=True, kw_only=True)
class BaselineSweep:
    """Every alternative against every other as baseline.

    Parameters
    ----------
    alternatives, criteria : tuple of str
    low, high : ndarray of int8, shape (alternatives, baselines, criteria)
        Worst and best sign of the row against the baseline of the column; the diagonal is ``S``.
    """

    alternatives: tuple[str, ...]
    criteria: tuple[str, ...]
    low: Signs
    high: Signs

    @cached_property
    def wins(self) -> NDArray[np.int64]:
        """On how many criteria the row certainly beats the column, shape (alternatives, alternatives)."""
        return np.asarray((self.low > 0).sum(axis=2), dtype=np.int64)

    @cached_property
    def beats(self) -> NDArray[np.bool_]:
        """Whether the row has more pluses than minuses against the column for any value of ``?``."""
        return np.asarray(self.low.sum(axis=2, dtype=np.int64) > 0)

    @property
    def condorcet_winner(self) -> str | None:
        """The alternative that certainly beats each other one; None where there is none (a cycle, ties or unknowns)."""
        others = len(self.alternatives) - 1
        hits = np.flatnonzero(self.beats.sum(axis=1) == others)
        return self.alternatives[int(hits[0])] if hits.size and others else None

    @property
    def winners(self) -> Mapping[str, tuple[str, ...]]:
        """The alternatives with the highest net of certain signs under each baseline, ties together."""
        nets = np.where(self.low == self.high, self.low, 0).sum(axis=2, dtype=np.int64)
        names = np.array(self.alternatives)
        return {
            baseline: tuple(names[column == column.max()].tolist())
            for baseline, column in zip(self.alternatives, nets.T, strict=True)
        }

    def against(self, baseline: str) -> PughResult:
        """Return the result with one of the alternatives as baseline."""
        if baseline not in self.alternatives:
            raise UnknownNameError(f"{baseline!r} is no alternative; {did_you_mean(baseline, self.alternatives)}")
        place = self.alternatives.index(baseline)
        return PughResult(
            baseline=baseline,
            alternatives=self.alternatives,
            criteria=self.criteria,
            low=self.low[:, place],
            high=self.high[:, place],
        )


def sweep_baselines(matrix: DecisionMatrix) -> BaselineSweep:
    """Compare all alternatives with each alternative as the baseline in turn."""
    low, high = _signs_against(matrix, np.arange(len(matrix.alternatives)))
    names = tuple(criterion.name for criterion in matrix.criteria)
    return BaselineSweep(alternatives=matrix.alternatives, criteria=names, low=low, high=high)


def _signs_against(matrix: DecisionMatrix, baselines: NDArray[np.intp]) -> tuple[Signs, Signs]:
    low, high = matrix.bounds
    shape = (len(matrix.alternatives), baselines.size, len(matrix.criteria))
    worst, best = np.empty(shape, np.int8), np.empty(shape, np.int8)
    for column, criterion in enumerate(matrix.criteria):
        poor, good = criterion.merit(low[:, column], high[:, column])
        worst[..., column] = _sign(poor[:, None], good[baselines][None, :], criterion, unknown=-1)
        best[..., column] = _sign(good[:, None], poor[baselines][None, :], criterion, unknown=1)
    itself = (baselines, np.arange(baselines.size))
    worst[itself], best[itself] = 0, 0
    return worst, best


def _sign(ours: NDArray[np.float64], baseline: NDArray[np.float64], criterion: Criterion, *, unknown: int) -> Signs:
    """Return the sign of ours - baseline outside the indifference band; interval ends give its extremes."""
    size = np.maximum(np.abs(ours), np.abs(baseline))
    rounding = 1e-12 * size
    band = np.maximum(criterion.indifference.absolute, criterion.indifference.relative * size) + rounding
    difference = ours - baseline
    sign = np.where(difference > band, 1, np.where(difference < -band, -1, 0))
    return np.where(np.isnan(difference), unknown, sign).astype(np.int8)
