"""One-sided exact confidence bounds of a share."""

from __future__ import annotations


def lower_bound(hits: int, trials: int, *, level: float = 0.95) -> float:
    """Return the exact lower confidence bound of a share, for ``hits`` of ``trials``.

    Source: Clopper and Pearson 1934, Biometrika 26(4), 404-413, one side only; 190 of 200 give 0.917.
    """
    if trials == 0 or hits == 0:
        return 0.0
    from scipy.special import betaincinv

    return float(betaincinv(hits, trials - hits + 1, 1.0 - level))


def upper_bound(hits: int, trials: int, *, level: float = 0.95) -> float:
    """Return the exact upper confidence bound of a share; 0 of 59 give 0.05."""
    return 1.0 - lower_bound(trials - hits, trials, level=level)
