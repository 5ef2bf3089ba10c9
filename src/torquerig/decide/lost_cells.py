"""Values of lost cells that give a printed sum: an exhaustive search over the steps of the scale."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from torquerig.decide.kesselring import Profile

# printed sums are rounded to two decimals
ROUNDING = 0.005 + 1e-9


def lost_cell_values(
    points: Sequence[float | None],
    *,
    weights: Sequence[float],
    total: float,
    profile: Profile,
    step: float = 0.5,
    rounding: float = ROUNDING,
) -> tuple[tuple[float, ...], ...]:
    """Return every way to fill the unknown cells of one column so that it gives the printed sum.

    Parameters
    ----------
    points : sequence of float or None, length criteria
        None where the cell is lost.
    weights : sequence of float, length criteria
    total : float
        The printed sum.
    profile : Profile
        The scale of the cells, in steps of ``step``.
    rounding : float
        The largest difference between the sum and the printed one.

    Returns
    -------
    tuple of tuples
        Full columns, the known cells kept; empty where the sum cannot be reached.
    """
    scale = np.arange(profile.p_min, profile.p_max + step / 2, step).tolist()
    lost = [place for place, one in enumerate(points) if one is None]
    found = []
    for values in product(scale, repeat=len(lost)):
        full = [0.0 if one is None else float(one) for one in points]
        for place, value in zip(lost, values, strict=True):
            full[place] = value
        if abs(float(np.dot(full, weights)) - total) <= rounding:
            found.append(tuple(full))
    return tuple(found)
