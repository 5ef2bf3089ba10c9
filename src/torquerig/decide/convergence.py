"""Pugh's controlled convergence: the strongest becomes the datum, again and again, until the datum stands.

Source: Pugh, Concept selection - a method that works, ICED 1981; Frey et al., The Pugh controlled convergence method,
Research in Engineering Design 20 (2009) 41-58. What a run cannot do is done by people between two runs: removing the
negatives of a strong concept, and combining concepts. So each run says where that would have to begin.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.pugh import DatumSweep, PughResult, Sign, pugh


@dataclass(frozen=True, kw_only=True)
class DatumStep:
    """One run with one datum.

    Parameters
    ----------
    datum, strongest : str
        ``strongest`` is the datum itself where nobody has more pluses than minuses against it.
    net_low, net_high : int
        The net of the strongest, with every ``?`` turned out badly and well.
    negatives : tuple of str
        The criteria in which the strongest is worse than the datum: what to attack.
    undiscriminating : tuple of str
        The criteria with the same certain sign for all but the datum: they decided nothing in this run.
    weak : tuple of str
        Those that are never better and somewhere worse than the datum, whatever the ``?`` turn out to be: what to drop.
    """

    datum: str
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
    steps : tuple of DatumStep
    stands : str
        The datum that nobody surely-signed beats; empty where the runs go round in a circle.
    circle : tuple of str
        The datums that follow each other for ever; empty where one stands.
    sure : bool
        Whether the datum stands whatever the ``?`` turn out to be.
    """

    steps: tuple[DatumStep, ...]
    stands: str
    circle: tuple[str, ...]
    sure: bool


def converge(matrix: DecisionMatrix, datum: str) -> Convergence:
    """Run Pugh from ``datum`` until the datum stands or a datum comes back.

    The strongest is who has the highest net of certain signs, then the most pluses, then the first place. Because signs
    come from values, a new datum needs no new judging.

    Raises
    ------
    UnknownNameError
        When the datum is not in the matrix.
    """
    steps: list[DatumStep] = []
    seen: list[str] = []
    while True:
        result = pugh(matrix, datum)
        step = _step(result)
        steps.append(step)
        seen.append(datum)
        if step.strongest == datum:
            sure = bool((result.net_high <= 0).all())
            return Convergence(steps=tuple(steps), stands=datum, circle=(), sure=sure)
        datum = step.strongest
        if datum in seen:
            circle = tuple(seen[seen.index(datum) :])
            return Convergence(steps=tuple(steps), stands="", circle=circle, sure=False)


def cycles(sweep: DatumSweep) -> tuple[tuple[str, ...], ...]:
    """Return a shortest circle a > b > ... > a of sure wins from each knot of alternatives that beat each other round.

    Empty where the wins are in order. Pairwise majorities may run in circles (Condorcet); then no ranking follows.
    """
    beats = sweep.beats
    reach = beats.copy()
    for middle in range(len(reach)):
        reach |= reach[:, middle, None] & reach[None, middle]
    left = {place for place in range(len(reach)) if reach[place, place]}
    found = []
    while left:
        knot = {other for other in left if reach[min(left), other] and reach[other, min(left)]}
        loop = min((_loop(beats, start, knot) for start in sorted(knot)), key=len)
        found.append(tuple(sweep.alternatives[place] for place in loop))
        left -= knot
    return tuple(found)


def _loop(beats: np.ndarray[tuple[int, ...], np.dtype[np.bool_]], start: int, knot: Iterable[int]) -> list[int]:
    """Return a shortest way from ``start`` back to it within the knot, without the return."""
    ways = [[start]]
    seen = {start}
    while ways:
        longer = []
        for way in ways:
            for other in sorted(knot):
                if beats[way[-1], other] and other == start:
                    return way
                if beats[way[-1], other] and other not in seen:
                    seen.add(other)
                    longer.append([*way, other])
        ways = longer
    return [start]


def _step(result: PughResult) -> DatumStep:
    pluses = np.array([result.counts(name)[Sign.BETTER] for name in result.alternatives])
    order = np.lexsort((np.arange(pluses.size), -pluses, -result.net_certain))
    place = int(order[0])
    datum = result.alternatives.index(result.datum)
    if result.net_certain[place] <= 0:
        place = datum
    low, high = (np.delete(ends, datum, axis=0) for ends in (result.low, result.high))
    flat: list[bool] = ((low == high) & (low == low[:1])).all(axis=0).tolist() if len(low) > 1 else []
    weak = (result.high <= 0).all(axis=1) & (result.low < 0).any(axis=1) & (result.high < 0).any(axis=1)
    strongest = result.alternatives[place]
    return DatumStep(
        datum=result.datum,
        strongest=strongest,
        net_low=int(result.net_low[place]),
        net_high=int(result.net_high[place]),
        negatives=_where(result.criteria, [sign is Sign.WORSE for sign in result.signs(strongest)]),
        undiscriminating=_where(result.criteria, flat) if flat else (),
        weak=tuple(result.alternatives[row] for row in np.flatnonzero(weak).tolist()),
    )


def _where(names: tuple[str, ...], flags: Iterable[bool]) -> tuple[str, ...]:
    return tuple(name for name, flag in zip(names, flags, strict=True) if flag)
