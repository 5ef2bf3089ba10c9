"""Count, mean, standard deviation and extremes of a block, and of two blocks joined."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True)
class Levels:
    """Statistics of the finite samples of a block, in the channel's unit; ``squares`` is the sum of (x - mean)^2."""

    count: int
    mean: float
    squares: float
    minimum: float
    maximum: float

    @property
    def std(self) -> float:
        """The standard deviation."""
        return sqrt(self.squares / self.count) if self.count else float("nan")


NOTHING = Levels(count=0, mean=float("nan"), squares=0.0, minimum=float("nan"), maximum=float("nan"))


def levels_of(values: NDArray[np.float64]) -> Levels:
    """Return the statistics of the finite samples of ``values``, shape (samples,); ``NOTHING`` where there are none."""
    if values.size == 0:
        return NOTHING
    mean = float(values.mean())
    if not np.isfinite(mean):
        finite = values[np.isfinite(values)]
        return levels_of(finite) if finite.size < values.size else _of_large(values)
    return Levels(
        count=values.size,
        mean=mean,
        squares=float(values.var()) * values.size,
        minimum=float(values.min()),
        maximum=float(values.max()),
    )


def joined_levels(first: Levels, last: Levels) -> Levels:
    """Return the statistics of two blocks together.

    Source: Chan, Golub & LeVeque 1983, Am Stat 37, eq. 2.1, without loss of digits in long recordings.
    """
    if not first.count or not last.count:
        return last if last.count else first
    count = first.count + last.count
    difference = last.mean - first.mean
    return Levels(
        count=count,
        mean=first.mean + difference * last.count / count,
        squares=first.squares + last.squares + difference**2 * first.count * last.count / count,
        minimum=min(first.minimum, last.minimum),
        maximum=max(first.maximum, last.maximum),
    )


def _of_large(values: NDArray[np.float64]) -> Levels:
    """Return the statistics of numbers so large that their sum overflows."""
    scaled = values / 2.0**200
    return Levels(
        count=values.size,
        mean=float(scaled.mean()) * 2.0**200,
        squares=float("inf"),
        minimum=float(values.min()),
        maximum=float(values.max()),
    )
