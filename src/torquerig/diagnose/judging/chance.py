"""How probable a residual is where many places were looked at."""

from __future__ import annotations

from math import erfc, sqrt


def by_chance(residual: float, places: int) -> float:
    """Return the two-sided probability of a normal residual so large somewhere among ``places`` (Bonferroni) [1]."""
    return min(1.0, places * erfc(residual / sqrt(2)))
