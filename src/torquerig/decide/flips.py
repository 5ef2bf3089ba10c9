"""Sensitivity of the winner: exact weights and the smallest change of a score at which another one wins."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from torquerig.decide.ranks import TIE
from torquerig.errors import InputError, UnknownNameError, did_you_mean

if TYPE_CHECKING:
    from torquerig.decide.kesselring import KesselringResult


@dataclass(frozen=True, kw_only=True)
class FlipWeight:
    """The raw weight of one criterion at which the winner and the other one tie; other weights fixed.

    ``flip`` is None where no weight of at least 0 makes them tie. ``change`` is the step from the present weight.
    """

    criterion: str
    winner: str
    other: str
    weight: float
    flip: float | None

    @property
    def change(self) -> float | None:
        """The step from the present weight to the flip."""
        return None if self.flip is None else self.flip - self.weight


@dataclass(frozen=True, kw_only=True)
class FlipScore:
    """The points of one cell at which the winner and the other one tie; all else fixed.

    ``flip`` is None where no points of the scale make them tie.
    """

    alternative: str
    criterion: str
    winner: str
    other: str
    points: float
    flip: float | None

    @property
    def change(self) -> float | None:
        """The step from the present points to the flip."""
        return None if self.flip is None else self.flip - self.points


@dataclass(frozen=True, kw_only=True)
class CommonFlip:
    """The largest common error of all points or all weights before another alternative can reach the winner.

    Parameters
    ----------
    scores : float or None
        If every cell may be off by this many points, within the scale; None where even the whole scale is not enough.
    weights : float or None
        If every raw weight may be off by this share of itself [1]; None where even 100 % is not enough.
    first_by_scores, first_by_weights : str
        The alternative that reaches the winner first.
    """

    scores: float | None
    weights: float | None
    first_by_scores: str
    first_by_weights: str


def flip_weights(result: KesselringResult, *, other: str | None = None) -> tuple[FlipWeight, ...]:
    """Return for each criterion the weight at which the other reaches the winner, in closed form.

    With lead D = T_winner - T_rival and the difference d_i of their points, the tie is at g_i - D / d_i.

    Parameters
    ----------
    result : KesselringResult
        Winner and runner-up are taken by ``total``, the first named where they tie.
    other : str or None
        The alternative to compare with; the runner-up by default.
    """
    order = _order(result)
    best, second = order[0], order[1]
    if other is not None:
        if other not in result.alternatives:
            raise UnknownNameError(f"{other!r} is no alternative; {did_you_mean(other, result.alternatives)}")
        second = result.alternatives.index(other)
        best = best if second != best else order[1]
    return tuple(_flip_weight(result, best, second, column) for column in range(len(result.criteria)))


def nearest_flips(result: KesselringResult) -> tuple[FlipWeight, ...]:
    """Return for each criterion the nearest weights below and above the present one at which any other one ties.

    Two, one or no entry for a criterion; those that need the smallest change, as a share of the weight, first.
    """
    best, *others = _order(result)
    found = []
    for column in range(len(result.criteria)):
        flips = [one for other in others if (one := _flip_weight(result, best, other, column)).flip is not None]
        for side in (-1, 1):
            near = [one for one in flips if (one.change or 0.0) * side > 0 or (side > 0 and not one.change)]
            found += [min(near, key=lambda one: abs(one.change or 0.0))] if near else []
    return tuple(sorted(found, key=lambda one: abs(one.change or 0.0) / one.weight))


def flip_scores(result: KesselringResult) -> tuple[FlipScore, ...]:
    """Return for every cell the points at which the winner changes, the smallest change first, in closed form.

    A cell of the winner must fall by D / g against the runner-up, a cell of another one must rise by its D / g.
    """
    best, *others = _order(result)
    found = []
    for column, criterion in enumerate(result.criteria):
        for row in (best, *others):
            other = others[0] if row == best else row
            step = float(result.total[best] - result.total[other]) / float(result.weights[column])
            points = float(result.middle[row, column])
            flip = points - step if row == best else points + step
            reached = result.profile.p_min - TIE <= flip <= result.profile.p_max + TIE
            found.append(
                FlipScore(
                    alternative=result.alternatives[row], criterion=criterion, winner=result.alternatives[best],
                    other=result.alternatives[other], points=points, flip=flip if reached else None,
                )
            )  # fmt: skip
    return tuple(sorted(found, key=lambda one: inf if one.change is None else abs(one.change)))


def common_flip(result: KesselringResult) -> CommonFlip:
    """Return the largest common error of all points, or of all weights, before the winner can change; exact."""
    best, *others = _order(result)
    scores = {other: _common_score(result, best, other) for other in others}
    weights = {other: _common_weight(result, best, other) for other in others}
    by_score, by_weight = min(others, key=lambda one: scores[one]), min(others, key=lambda one: weights[one])
    return CommonFlip(
        scores=None if scores[by_score] == inf else scores[by_score],
        weights=None if weights[by_weight] > 1 else weights[by_weight],
        first_by_scores=result.alternatives[by_score],
        first_by_weights=result.alternatives[by_weight],
    )


def _order(result: KesselringResult) -> list[int]:
    if len(result.alternatives) < 2:
        raise InputError("there is only one alternative; a flip weight needs two")
    order: list[int] = np.argsort(-result.total, kind="stable").tolist()
    return order


def _flip_weight(result: KesselringResult, best: int, other: int, column: int) -> FlipWeight:
    lead = float(result.total[best] - result.total[other])
    weight = float(result.weights[column])
    difference = float(result.middle[best, column] - result.middle[other, column])
    flip = weight - lead / difference if abs(difference) > TIE else None
    return FlipWeight(
        criterion=result.criteria[column],
        winner=result.alternatives[best],
        other=result.alternatives[other],
        weight=weight,
        flip=None if flip is None or flip < -TIE else 0.0 if flip <= TIE else flip,
    )


def _common_score(result: KesselringResult, best: int, other: int) -> float:
    """Return the step at which the lead is 0; it is piecewise linear, with knots where a cell leaves the scale."""
    ours, theirs = result.middle[best], result.middle[other]
    floor, ceiling = result.profile.p_min, result.profile.p_max

    def lead(step: float) -> float:
        gap = np.maximum(ours - step, floor) - np.minimum(theirs + step, ceiling)
        return float((result.weights * gap).sum())

    edges = sorted({0.0, *(ours - floor).tolist(), *(ceiling - theirs).tolist()})
    if lead(0.0) <= TIE:
        return 0.0
    for left, right in pairwise(edges):
        if lead(right) <= TIE:
            return float(left + (right - left) * lead(left) / (lead(left) - lead(right)))
    return inf


def _common_weight(result: KesselringResult, best: int, other: int) -> float:
    differences = result.weights * (result.middle[best] - result.middle[other])
    return float(differences.sum() / np.abs(differences).sum()) if np.abs(differences).sum() > TIE else 0.0
