"""What would have to be different for another one to win: exact weights and the smallest change of a score."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import inf

import numpy as np

from torquerig.decide.kesselring import KesselringResult
from torquerig.decide.ranks import TIE
from torquerig.errors import InputError, UnknownNameError, did_you_mean


@dataclass(frozen=True, kw_only=True)
class FlipWeight:
    """The raw weight of one criterion at which winner and rival tie, the other raw weights held.

    ``flip`` is None where no weight of at least 0 makes them tie. ``change`` is the step from the present weight.
    """

    criterion: str
    winner: str
    rival: str
    weight: float
    flip: float | None

    @property
    def change(self) -> float | None:
        """The step from the present weight to the flip."""
        return None if self.flip is None else self.flip - self.weight


@dataclass(frozen=True, kw_only=True)
class FlipScore:
    """The points of one cell at which winner and rival tie, all else held.

    ``flip`` is None where no points of the scale make them tie.
    """

    alternative: str
    criterion: str
    winner: str
    rival: str
    points: float
    flip: float | None

    @property
    def change(self) -> float | None:
        """The step from the present points to the flip."""
        return None if self.flip is None else self.flip - self.points


@dataclass(frozen=True, kw_only=True)
class CommonFlip:
    """How far everything at once may be off before some rival can catch up with the winner.

    Parameters
    ----------
    scores : float or None
        If every cell may be off by this many points, within the scale; None where even the whole scale is not enough.
    weights : float or None
        If every raw weight may be off by this share of itself [1]; None where even 100 % is not enough.
    score_rival, weight_rival : str
        Who catches up first.
    """

    scores: float | None
    weights: float | None
    score_rival: str
    weight_rival: str


def flip_weights(result: KesselringResult, *, rival: str | None = None) -> tuple[FlipWeight, ...]:
    """Return for each criterion the weight that would make the rival catch up with the winner, in closed form.

    With lead D = T_winner - T_rival and the difference d_i of their points, the tie is at g_i - D / d_i.

    Parameters
    ----------
    result : KesselringResult
        Winner and runner-up are taken by ``total``, the first named where they tie.
    rival : str or None
        Another alternative than the runner-up.
    """
    order = _order(result)
    best, second = order[0], order[1]
    if rival is not None:
        if rival not in result.alternatives:
            raise UnknownNameError(f"{rival!r} is no alternative; {did_you_mean(rival, result.alternatives)}")
        second = result.alternatives.index(rival)
        best = best if second != best else order[1]
    return tuple(_flip_weight(result, best, second, column) for column in range(len(result.criteria)))


def nearest_flips(result: KesselringResult) -> tuple[FlipWeight, ...]:
    """Return for each criterion the nearest weights below and above the present one at which any rival ties.

    Two, one or no entry for a criterion; those that need the smallest change, as a share of the weight, first.
    """
    best, *rivals = _order(result)
    found = []
    for column in range(len(result.criteria)):
        flips = [one for rival in rivals if (one := _flip_weight(result, best, rival, column)).flip is not None]
        for side in (-1, 1):
            near = [one for one in flips if (one.change or 0.0) * side > 0 or (side > 0 and not one.change)]
            found += [min(near, key=lambda one: abs(one.change or 0.0))] if near else []
    return tuple(sorted(found, key=lambda one: abs(one.change or 0.0) / one.weight))


def flip_scores(result: KesselringResult) -> tuple[FlipScore, ...]:
    """Return for every cell the points at which the winner changes, the smallest change first, in closed form.

    A cell of the winner must fall by D / g against the runner-up, a cell of a rival rise by its own D / g.
    """
    best, *rivals = _order(result)
    found = []
    for column, criterion in enumerate(result.criteria):
        for row in (best, *rivals):
            rival = rivals[0] if row == best else row
            step = float(result.total[best] - result.total[rival]) / float(result.weights[column])
            points = float(result.middle[row, column])
            flip = points - step if row == best else points + step
            reached = result.profile.p_min - TIE <= flip <= result.profile.p_max + TIE
            found.append(
                FlipScore(
                    alternative=result.alternatives[row], criterion=criterion, winner=result.alternatives[best],
                    rival=result.alternatives[rival], points=points, flip=flip if reached else None,
                )
            )  # fmt: skip
    return tuple(sorted(found, key=lambda one: inf if one.change is None else abs(one.change)))


def common_flip(result: KesselringResult) -> CommonFlip:
    """Return how far all points, or all weights, may be off at once before the winner can change; exact."""
    best, *rivals = _order(result)
    scores = {rival: _common_score(result, best, rival) for rival in rivals}
    weights = {rival: _common_weight(result, best, rival) for rival in rivals}
    by_score, by_weight = min(rivals, key=lambda one: scores[one]), min(rivals, key=lambda one: weights[one])
    return CommonFlip(
        scores=None if scores[by_score] == inf else scores[by_score],
        weights=None if weights[by_weight] > 1 else weights[by_weight],
        score_rival=result.alternatives[by_score],
        weight_rival=result.alternatives[by_weight],
    )


def _order(result: KesselringResult) -> list[int]:
    if len(result.alternatives) < 2:
        raise InputError("one alternative has no rival; a flip weight needs two")
    order: list[int] = np.argsort(-result.total, kind="stable").tolist()
    return order


def _flip_weight(result: KesselringResult, best: int, rival: int, column: int) -> FlipWeight:
    lead = float(result.total[best] - result.total[rival])
    weight = float(result.weights[column])
    difference = float(result.middle[best, column] - result.middle[rival, column])
    flip = weight - lead / difference if abs(difference) > TIE else None
    return FlipWeight(
        criterion=result.criteria[column],
        winner=result.alternatives[best],
        rival=result.alternatives[rival],
        weight=weight,
        flip=None if flip is None or flip < -TIE else 0.0 if flip <= TIE else flip,
    )


def _common_score(result: KesselringResult, best: int, rival: int) -> float:
    """Return where the lead, which falls in straight lines between the steps at which a cell leaves the scale, is 0."""
    ours, theirs = result.middle[best], result.middle[rival]
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


def _common_weight(result: KesselringResult, best: int, rival: int) -> float:
    differences = result.weights * (result.middle[best] - result.middle[rival])
    return float(differences.sum() / np.abs(differences).sum()) if np.abs(differences).sum() > TIE else 0.0
