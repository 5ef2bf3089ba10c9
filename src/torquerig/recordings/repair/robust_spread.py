"""How far values scatter, told by the half of them that is nearest: what stands out of them hardly moves it.

Half of a normal variate lies within 0.6745 standard deviations of its mean (Hampel 1974, J. Am. Stat. Assoc. 69).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_HALF_WITHIN = 0.6745


def spread_about_zero(values: Floats) -> float:
    """Return the standard deviation that a normal variate of mean zero has whose half lies as near to it.

    It is 0 where there are no values.
    """
    if not values.size:
        return 0.0
    return float(np.median(np.abs(values))) / _HALF_WITHIN


def spread_about_median(values: Floats) -> float:
    """Return the same of values whose mean is not known."""
    return spread_about_zero(values - np.median(values)) if values.size else 0.0
