"""Distribution of a figure over draws, and how well the draws determine it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

QUANTILES = (0.05, 0.5, 0.95)
DEVIATIONS = 1.96  # [1] standard deviations of a 95 % interval


@dataclass(frozen=True)
class Distribution:
    """Quantiles of a figure.

    Parameters
    ----------
    draws : int
        That have a value.
    low, median, high : float
        The 5, 50 and 95 % quantiles, in the figure's unit.
    median_low, median_high : float
        95 % interval of the median by the number of draws, from order statistics: the number of draws below the true
        median is binomial (David and Nagaraja, Order Statistics, section 7.1). As wide as all draws where they are too
        few for one.
    """

    draws: int
    low: float
    median: float
    high: float
    median_low: float
    median_high: float

    @property
    def uncertainty(self) -> float:
        """Half the width of the median's interval over the median [1]; 0 for a median of 0."""
        return 0.5 * (self.median_high - self.median_low) / abs(self.median) if self.median else 0.0


def distribution(values: NDArray[np.float64]) -> Distribution | None:
    """Return the distribution of values, shape (draws,), NaN where a draw has none; None without any."""
    known = np.sort(values[np.isfinite(values)])
    if not known.size:
        return None
    low, median, high = np.quantile(known, QUANTILES)
    reach = DEVIATIONS * np.sqrt(known.size) / 2
    first = max(0, int(np.floor(known.size / 2 - reach)) - 1)
    last = min(known.size - 1, int(np.ceil(known.size / 2 + reach)))
    return Distribution(known.size, float(low), float(median), float(high), float(known[first]), float(known[last]))


def share_uncertainty(share: float, draws: int) -> float:
    """Return the half-width of the 95 % interval of a share of draws (Wilson 1927, J. Amer. Statist. Assoc. 22)."""
    z = DEVIATIONS
    return float(z / (1 + z**2 / draws) * np.sqrt(share * (1 - share) / draws + z**2 / (4 * draws**2)))
