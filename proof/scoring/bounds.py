"""What can be said for sure of a share that was counted? One-sided exact bounds."""

from __future__ import annotations


def lower_bound(hits: int, trials: int, *, level: float = 0.95) -> float:
    """Largest share that so many hits or more would refute at this level, exactly.

    Source: Clopper and Pearson 1934, Biometrika 26(4), 404-413, one side only; 190 of 200 give 0.917.
    """
    if trials == 0 or hits == 0:
        return 0.0
    from scipy.special import betaincinv

    return float(betaincinv(hits, trials - hits + 1, 1.0 - level))


def upper_bound(hits: int, trials: int, *, level: float = 0.95) -> float:
    """Smallest share that so many hits or fewer would refute at this level; 0 of 59 give 0.05."""
    return 1.0 - lower_bound(trials - hits, trials, level=level)
