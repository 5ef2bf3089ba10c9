"""Rank acceptability: the share of Monte Carlo samples in which each alternative takes each rank."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.monte_carlo import SamplingPlan, Uncertainty, sampling_plan, separate_uncertainties
from torquerig.decide.ranks import TIE
from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.decide.matrix import DecisionMatrix

Array = NDArray[np.float64]
CHUNK = 1 << 16  # samples of one thread at a time; fixed, so that sums do not depend on how many threads there are
THREADS = 2
FEW = 25_000  # samples up to which a second thread costs more than it saves


@dataclass(frozen=True, kw_only=True)
class RankAcceptability:
    """The share of Monte Carlo samples in which each alternative takes each rank.

    Parameters
    ----------
    shares : ndarray, shape (alternatives, ranks)
        Rows and columns sum to 1; a tie shares the ranks that it covers equally.
    mean_share : ndarray, shape (alternatives,)
        The mean of T/T_max over the samples.
    uncertainty : Uncertainty
        What was sampled.

    Notes
    -----
    The rank acceptability index b_i^r of Lahdelma and Salminen, SMAA-2, Operations Research 49 (2001) 444-454.
    """

    alternatives: tuple[str, ...]
    shares: Array
    mean_share: Array
    uncertainty: Uncertainty
    draws: int
    seed: int

    @property
    def p_best(self) -> Array:
        """The share of samples in which each is best, shape (alternatives,)."""
        return np.asarray(self.shares[:, 0])

    @cached_property
    def mean_rank(self) -> Array:
        """The mean rank, shape (alternatives,)."""
        return np.asarray(self.shares @ np.arange(1, self.shares.shape[1] + 1))

    def best_share(self, alternative: str) -> float:
        """Return the share of samples in which one alternative is best."""
        return float(self.p_best[self.alternatives.index(alternative)])


def rank_acceptability(
    matrix: DecisionMatrix,
    *,
    profile: Profile = TEACHING,
    uncertainty: Uncertainty | None = None,
    draws: int = 10_000,
    seed: int = 0,
) -> RankAcceptability:
    """Sample values, points and weights jointly within ``uncertainty`` and count the ranks of each alternative.

    Values are uniform over their intervals (log-uniform where high/low > 5) and go through the value functions; an
    unknown cell gets uniform points from the whole scale. Cells that depend on one fact are sampled together, others
    independently. Where catalog values share an error that no ``fact`` names, the result is too certain.
    """
    uncertainty = Uncertainty() if uncertainty is None else uncertainty
    ready = sampling_plan(matrix, profile=profile, uncertainty=uncertainty, seed=seed)
    counts, sums = _counted(ready, draws)
    return RankAcceptability(
        alternatives=matrix.alternatives,
        shares=counts / draws,
        mean_share=sums / (draws * profile.p_max),
        uncertainty=uncertainty,
        draws=draws,
        seed=seed,
    )


def robustness(
    matrix: DecisionMatrix,
    *,
    profile: Profile = TEACHING,
    uncertainty: Uncertainty | None = None,
    draws: int = 10_000,
    seed: int = 0,
) -> Mapping[str, RankAcceptability]:
    """Return the acceptability for ``intervals``, ``scores`` and ``weights`` each alone, and ``together``."""
    return {
        name: rank_acceptability(matrix, profile=profile, uncertainty=one, draws=draws, seed=seed)
        for name, one in separate_uncertainties(Uncertainty() if uncertainty is None else uncertainty).items()
    }


def _counted(ready: SamplingPlan, draws: int) -> tuple[Array, Array]:
    """Return the counts of each rank, and the sums of T over the sum of the weights."""
    from torquerig.decide.kernel import count_ranks

    if draws < 1:
        raise InputError(f"{draws} Monte Carlo samples are too few; use 1 or more")
    rows = len(ready.alternatives)

    def chunk(first: int) -> tuple[Array, Array]:
        counts, sums = np.zeros((rows, rows)), np.zeros(rows)
        size = min(CHUNK, draws - first)
        count_ranks(first, size, ready.cells, ready.weights, ready.scale, TIE, counts, sums)
        return counts, sums

    starts = range(0, draws, CHUNK)
    if draws <= FEW:
        parts = [chunk(first) for first in starts]
    else:
        with ThreadPoolExecutor(THREADS) as pool:
            parts = list(pool.map(chunk, starts))
    counts, sums = parts[0]
    for more_counts, more_sums in parts[1:]:
        counts, sums = counts + more_counts, sums + more_sums
    return counts, sums
