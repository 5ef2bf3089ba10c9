"""Pugh's controlled convergence: the strongest alternative becomes the baseline until no other one is stronger.

Source: Pugh, Concept selection - a method that works, ICED 1981; Frey et al., The Pugh controlled convergence method,
Research in Engineering Design 20 (2009) 41-58. Between two runs, people remove the negatives of a strong concept and
combine concepts. Each run therefore lists the criteria in which the strongest alternative is worse.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.decide.pugh import BaselineSweep, PughResult, Sign, pugh

if TYPE_CHECKING:
    from torquerig.decide.matrix import DecisionMatrix


@dataclass(frozen=True, kw_only=True)
class BaselineStep:
    """One run with one baseline.

    Parameters
    ----------
    baseline, strongest : str
        ``strongest`` is the baseline itself where no alternative has more pluses than minuses against it.
    net_low, net_high : int
        The net score of the strongest, with every ``?`` counted as ``-`` and as ``+``.
    negatives : tuple of str
        The criteria in which the strongest is worse than the baseline: the ones to improve.
    undiscriminating : tuple of str
        The criteria with the same certain sign for all alternatives but the baseline.
    weak : tuple of str
        Alternatives that are never better and somewhere worse than the baseline, for any value of ``?``: to be dropped.
    """

    baseline: str
    strongest: str
    net_low: int
    net_high: int
    negatives: tuple[str, ...]
    undiscriminating: tuple[str, ...]
    weak: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Convergence:
    """All runs, in order.

    Parameters
    ----------
    steps : tuple of BaselineStep
    stable : str
        The baseline that no alternative beats by certain signs; empty where the runs form a cycle.
    cycle : tuple of str
        The baselines that follow each other in a cycle; empty where one is stable.
    sure : bool
        Whether the baseline is stable for any value of ``?``.
    """

    steps: tuple[BaselineStep, ...]
    stable: str
    cycle: tuple[str, ...]
    sure: bool


def converge(matrix: DecisionMatrix, baseline: str) -> Convergence:
    """Run Pugh from ``baseline`` until the baseline is stable or a former baseline returns.

    The strongest alternative has the highest net of certain signs, then the most pluses, then the first place. Signs
    come from values, so that a new baseline needs no new rating.

    Raises
    ------
    UnknownNameError
        When the baseline is not in the matrix.
    """
    steps: list[BaselineStep] = []
    seen: list[str] = []
    while True:
        result = pugh(matrix, baseline)
        step = _step(result)
        steps.append(step)
        seen.append(baseline)
        if step.strongest == baseline:
            sure = bool((result.net_high <= 0).all())
            return Convergence(steps=tuple(steps), stable=baseline, cycle=(), sure=sure)
        baseline = step.strongest
        if baseline in seen:
            circle = tuple(seen[seen.index(baseline) :])
            return Convergence(steps=tuple(steps), stable="", cycle=circle, sure=False)


def cycles(sweep: BaselineSweep) -> tuple[tuple[str, ...], ...]:
    """Return a shortest cycle a > b > ... > a of certain wins from each group of alternatives that beat each other.

    Empty where there is no cycle. Pairwise majorities may form cycles (Condorcet); then no ranking follows.
    """
    beats = sweep.beats
    reach = beats.copy()
    for middle in range(len(reach)):
        reach |= reach[:, middle, None] & reach[None, middle]
    remaining = {place for place in range(len(reach)) if reach[place, place]}
    found = []
    while remaining:
        group = {other for other in remaining if reach[min(remaining), other] and reach[other, min(remaining)]}
        loop = min((_loop(beats, start, group) for start in sorted(group)), key=len)
        found.append(tuple(sweep.alternatives[place] for place in loop))
        remaining -= group
    return tuple(found)


def _loop(beats: np.ndarray[tuple[int, ...], np.dtype[np.bool_]], start: int, group: Iterable[int]) -> list[int]:
    """Return a shortest path from ``start`` back to it within the group, without the last step."""
    ways = [[start]]
    seen = {start}
    while ways:
        longer = []
        for way in ways:
            for other in sorted(group):
                if beats[way[-1], other] and other == start:
                    return way
                if beats[way[-1], other] and other not in seen:
                    seen.add(other)
                    longer.append([*way, other])
        ways = longer
    return [start]


def _step(result: PughResult) -> BaselineStep:
    pluses = np.array([result.counts(name)[Sign.BETTER] for name in result.alternatives])
    order = np.lexsort((np.arange(pluses.size), -pluses, -result.net_certain))
    place = int(order[0])
    baseline = result.alternatives.index(result.baseline)
    if result.net_certain[place] <= 0:
        place = baseline
    low, high = (np.delete(ends, baseline, axis=0) for ends in (result.low, result.high))
    flat: list[bool] = ((low == high) & (low == low[:1])).all(axis=0).tolist() if len(low) > 1 else []
    weak = (result.high <= 0).all(axis=1) & (result.low < 0).any(axis=1) & (result.high < 0).any(axis=1)
    strongest = result.alternatives[place]
    return BaselineStep(
        baseline=result.baseline,
        strongest=strongest,
        net_low=int(result.net_low[place]),
        net_high=int(result.net_high[place]),
        negatives=_where(result.criteria, [sign is Sign.WORSE for sign in result.signs(strongest)]),
        undiscriminating=_where(result.criteria, flat) if flat else (),
        weak=tuple(result.alternatives[row] for row in np.flatnonzero(weak).tolist()),
    )


def _where(names: tuple[str, ...], flags: Iterable[bool]) -> tuple[str, ...]:
    return tuple(name for name, flag in zip(names, flags, strict=True) if flag)
