"""How sure the winner is: the weight that would flip it, and how often each alternative is best over the intervals."""

from __future__ import annotations

import zlib
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.kesselring import TEACHING, KesselringResult, Profile, kesselring, rated_criteria
from torquerig.decide.matrix import DecisionMatrix
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
    if len(result.alternatives) < 2:
        raise InputError("one alternative has no rival; a flip weight needs two")
    order = np.argsort(-result.total, kind="stable")
    best, second = int(order[0]), int(order[1])
    if rival is not None:
        if rival not in result.alternatives:
            raise UnknownNameError(f"{rival!r} is no alternative; {did_you_mean(rival, result.alternatives)}")
        second = result.alternatives.index(rival)
        best = best if second != best else int(order[1])
    lead = float(result.total[best] - result.total[second])
    flips = []
    for column, criterion in enumerate(result.criteria):
        weight = float(result.weights[column])
        difference = float(result.middle[best, column] - result.middle[second, column])
        flip = weight - lead / difference if abs(difference) > TIE else None
        flips.append(
            FlipWeight(
                criterion=criterion,
                winner=result.alternatives[best],
                rival=result.alternatives[second],
                weight=weight,
                flip=flip if flip is not None and flip >= -TIE else None,
            )
        )
    return tuple(flips)


@dataclass(frozen=True, kw_only=True)
class BestShares:
    """How often each alternative has the highest T; a tie is shared equally."""

    alternatives: tuple[str, ...]
    p_best: NDArray[np.float64]
    draws: int
    seed: int


def best_shares(
    matrix: DecisionMatrix, *, profile: Profile = TEACHING, draws: int = 10_000, seed: int = 0
) -> BestShares:
    """Draw every interval at once and count who is best; an unknown cell is drawn over the whole scale.

    Values are drawn uniformly and independently over their intervals and go through the value functions. Each cell has
    its own stream by name, so that adding an alternative does not change the draws of the others. Where catalog values
    share an error (the same maker's tolerance), independence makes the result look surer than it is.
    """
    result = kesselring(matrix, profile=profile)
    rated = rated_criteria(matrix, profile)
    totals = np.repeat(result.total[:, None], draws, axis=1)
    for row, column in np.argwhere(result.high - result.low > 0).tolist():
        alternative, criterion = matrix.alternatives[row], rated[column]
        rng = _stream(seed, alternative, criterion.name)
        cell = matrix.cell(alternative, criterion.name)
        if cell.unknown or criterion.value is None:
            points = rng.uniform(profile.p_min, profile.p_max, draws)
        else:
            points = criterion.value.points(rng.uniform(*cell.bounds, draws))
        totals[row] += criterion.weight * (points - result.middle[row, column])
    best = totals >= totals.max(axis=0) - TIE
    return BestShares(
        alternatives=matrix.alternatives, p_best=(best / best.sum(axis=0)).mean(axis=1), draws=draws, seed=seed
    )


def _stream(seed: int, *names: str) -> np.random.Generator:
    keys = tuple(zlib.crc32(name.encode()) for name in names)
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=keys))
