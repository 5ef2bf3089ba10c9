"""How sure the winner is: how often each alternative takes each rank when everything in doubt is drawn at once."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from torquerig.decide.draws import Doubt, Draws, prepared, sources
from torquerig.decide.kesselring import TEACHING, Profile
from torquerig.decide.matrix import DecisionMatrix
from torquerig.decide.ranks import TIE
from torquerig.errors import InputError

Array = NDArray[np.float64]
CHUNK = 1 << 16  # draws of one thread at a time; fixed, so that sums do not depend on how many threads there are
THREADS = 2
FEW = 25_000  # draws up to which a second thread costs more than it saves


@dataclass(frozen=True, kw_only=True)
class Acceptability:
    """How often each alternative takes each rank.

    Parameters
    ----------
    shares : ndarray, shape (alternatives, ranks)
        Rows and columns sum to 1; a tie shares the ranks that it covers equally.
    mean_share : ndarray, shape (alternatives,)
        The mean of T/T_max over the draws.
    doubt : Doubt
        What was drawn.

    Notes
    -----
    The rank acceptability index b_i^r of Lahdelma and Salminen, SMAA-2, Operations Research 49 (2001) 444-454.
    """

    alternatives: tuple[str, ...]
    shares: Array
    mean_share: Array
    doubt: Doubt
    draws: int
    seed: int

    @property
    def p_best(self) -> Array:
        """How often each is best, shape (alternatives,)."""
        return np.asarray(self.shares[:, 0])

    @cached_property
    def mean_rank(self) -> Array:
        """The mean rank, shape (alternatives,)."""
        return np.asarray(self.shares @ np.arange(1, self.shares.shape[1] + 1))

    def chance(self, alternative: str) -> float:
        """Return how often one alternative is best."""
        return float(self.p_best[self.alternatives.index(alternative)])


def rank_acceptability(
    matrix: DecisionMatrix,
    *,
    profile: Profile = TEACHING,
    doubt: Doubt | None = None,
    draws: int = 10_000,
    seed: int = 0,
) -> Acceptability:
    """Draw values, points and weights jointly, as far as ``doubt`` has them, and count who takes which rank.

    Values are drawn evenly over their intervals (evenly in the logarithm where high/low > 5) and go through the value
    functions; an unknown cell gets points from the whole scale. Cells that rest on one fact are drawn together, all
    others independently; where catalog values share an error that no ``fact`` names, the result looks surer than it is.
    """
    doubt = Doubt() if doubt is None else doubt
    ready = prepared(matrix, profile=profile, doubt=doubt, seed=seed)
    counts, sums = _counted(ready, draws)
    return Acceptability(
        alternatives=matrix.alternatives,
        shares=counts / draws,
        mean_share=sums / (draws * profile.p_max),
        doubt=doubt,
        draws=draws,
        seed=seed,
    )


def robustness(
    matrix: DecisionMatrix,
    *,
    profile: Profile = TEACHING,
    doubt: Doubt | None = None,
    draws: int = 10_000,
    seed: int = 0,
) -> Mapping[str, Acceptability]:
    """Return the acceptability for ``intervals``, ``scores`` and ``weights`` each alone, and ``together``."""
    return {
        name: rank_acceptability(matrix, profile=profile, doubt=one, draws=draws, seed=seed)
        for name, one in sources(Doubt() if doubt is None else doubt).items()
    }


def _counted(ready: Draws, draws: int) -> tuple[Array, Array]:
    """Return how often each takes each rank, and the sums of T over sum of weights."""
    from torquerig.decide.kernel import count_ranks

    if draws < 1:
        raise InputError(f"{draws} draws tell nothing; ask for 1 or more")
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
