"""The mean torque of a load, stated at some occupancies of the drum."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from torquerig.errors import InputError


def refuse_empty(mean_by_occupancy_percent: Mapping[float, float]) -> None:
    """Raise ValueError, for the reader of a scenario to place, where no mean is stated."""
    if not mean_by_occupancy_percent:
        raise ValueError("mean_by_occupancy_percent is empty; write for example {0: 0.05 N*m, 21: 3.8 N*m}")


def mean_at(occupancy_percent: float, mean_by_occupancy_percent: Mapping[float, float], *, name: str) -> float:
    """Return the mean torque [N m], linear between the stated occupancies.

    Raises
    ------
    InputError
        Outside them: nobody knows the load there. It begins with the ``name`` of the load.
    """
    stated = sorted(mean_by_occupancy_percent)
    if not stated[0] <= occupancy_percent <= stated[-1]:
        raise InputError(
            f"{name}: occupancy {occupancy_percent:g} % is outside {stated[0]:g}..{stated[-1]:g} %, where the "
            "load is known; add a mean torque for it to mean_by_occupancy_percent"
        )
    return float(np.interp(occupancy_percent, stated, [mean_by_occupancy_percent[key] for key in stated]))
