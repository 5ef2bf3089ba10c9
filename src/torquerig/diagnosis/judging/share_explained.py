"""How much of what was missed goes at the places that an effect changes for the better."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

CHANGED = 2.0  # a feature belongs to the effect's place when its robust square falls by more than this
LEAST_SHARE = 0.8  # of the misfit at its places: an effect that is there explains them, a stand-in leaves a rest


def share_explained(
    old: NDArray[np.float64], new: NDArray[np.float64], *, beside: tuple[float, float] = (0.0, 0.0)
) -> float:
    """Return 1 - (excess left) / (excess before) over the features that fall clearly; 0 where none does.

    Parameters
    ----------
    old, new : array (n,)
        Robust squares of every feature before and after, 1 by chance.
    beside : tuple of float
        What is missed before and after of what no feature holds.
    """
    place = old - new > CHANGED
    excess = float(np.maximum(old[place] - 1, 0).sum()) + beside[0]
    return 1 - (float(np.maximum(new[place] - 1, 0).sum()) + beside[1]) / excess if excess > 0 else 0.0
