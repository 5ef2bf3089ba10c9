"""Rank conventions, and the ranks that score intervals allow; a higher score is better everywhere."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

# sums of decimal weights differ in the last bits; closer than this is a tie
TIE = 1e-9


def competition_ranks(scores: ArrayLike) -> NDArray[np.int64]:
    """Return shared competition ranks, the convention of this package: 1, 2, 2, 4; shape (alternatives,)."""
    values = np.asarray(scores, dtype=float)
    return np.asarray(1 + (values[None, :] > values[:, None] + TIE).sum(axis=1), dtype=np.int64)


def dense_ranks(scores: ArrayLike) -> NDArray[np.int64]:
    """Return dense ranks, without gaps after a tie: 1, 2, 2, 3; shape (alternatives,)."""
    values = np.round(np.asarray(scores, dtype=float), 9)
    return np.asarray([1 + len({other for other in values.tolist() if other > value}) for value in values], np.int64)


def rank_intervals(low: ArrayLike, high: ArrayLike) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the best and the worst rank that score intervals allow each alternative; two arrays (alternatives,).

    Parameters
    ----------
    low, high : array_like, shape (alternatives,)
        Ends of the score intervals, taken as independent of each other.
    """
    lows, highs = np.asarray(low, dtype=float), np.asarray(high, dtype=float)
    surely_above = lows[None, :] > highs[:, None] + TIE
    maybe_above = highs[None, :] > lows[:, None] + TIE
    np.fill_diagonal(maybe_above, False)
    return np.asarray(1 + surely_above.sum(axis=1), np.int64), np.asarray(1 + maybe_above.sum(axis=1), np.int64)


def shown_rank(best: int, worst: int) -> str:
    """Return ``2`` or ``1..3`` for a table."""
    return str(best) if best == worst else f"{best}..{worst}"
