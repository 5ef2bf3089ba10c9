"""A choice within the bounds of an optimisation, and the point of the search that stands for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import exp, log

import numpy as np
from numpy.typing import NDArray

from torquerig.study.optimisation.bounds import Bounds


@dataclass(frozen=True)
class Choice:
    """Numbers that a drive, its speed loop and its filters are made with.

    Parameters
    ----------
    crossover, corner : float
        Of the speed loop and its integrator [Hz].
    ratio : float or None
        Motor turns per output turn [1]; None for a gearbox of the catalog.
    numbers : tuple of float or None
        One for each varied number of the filters [SI]; None for filters as stated.
    """

    crossover: float
    corner: float
    ratio: float | None = None
    numbers: tuple[float, ...] | None = None


def limits_of(bounds: Bounds) -> list[tuple[float, float]]:
    """Return the limits of each number of a point: logarithms of the loop and the ratio, shares of the filters."""
    logarithmic = [bounds.crossover, bounds.integral_corner]
    if bounds.ratio is not None:
        logarithmic.append((bounds.ratio.low, bounds.ratio.high))
    return [*((log(low), log(high)) for low, high in logarithmic), *((0.0, 1.0) for _ in bounds.numbers)]


def choice_at(point: NDArray[np.float64], bounds: Bounds) -> Choice:
    """Return the choice of a point."""
    count = 2 if bounds.ratio is None else 3
    crossover, corner, *ratio = (exp(one) for one in point[:count])
    numbers = tuple(number.at(float(share)) for number, share in zip(bounds.numbers, point[count:], strict=True))
    return Choice(crossover, corner, ratio[0] if ratio else None, numbers if bounds.numbers else None)


def settings_at(bounds: Bounds, choice: Choice, rows: Sequence[int], *, count: int, seed: int) -> Iterator[Choice]:
    """Yield the choice with other values of some varied numbers, spread evenly over their bounds (Sobol)."""
    from scipy.stats import qmc

    assert choice.numbers is not None
    for shares in qmc.Sobol(len(rows), rng=seed).random(count):
        numbers = list(choice.numbers)
        for row, share in zip(rows, shares, strict=True):
            numbers[row] = bounds.numbers[row].at(float(share))
        yield replace(choice, numbers=tuple(numbers))
