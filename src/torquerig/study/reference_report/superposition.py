"""A reading as lines plus a scalable load: the reduction by a linear filter in closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.filters.chains.filter_chain import Chain
from torquerig.study.reference_report.conditions import ReportRig

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

_LARGEST = 20.0  # [1] largest searched fluctuation over that of the scenario


@dataclass(frozen=True)
class Superposed:
    """Covariances of lines (and noise) with the load's fluctuation at scale 1, before and after a linear chain.

    Parameters
    ----------
    mean : float
        Of the reading [N m].
    before, after : tuple of float
        Variance of the lines, covariance, variance of the load [(N m)^2].
    """

    mean: float
    before: tuple[float, float, float]
    after: tuple[float, float, float]

    def cut(self, scale: float | Floats) -> float | Floats:
        """Return the reduction of the standard deviation [%] with the load's fluctuation times ``scale``."""
        first, last = (_variance(parts, scale) for parts in (self.before, self.after))
        return 100 * (1 - np.sqrt(np.maximum(last, 0.0) / first))

    def lines(self) -> float:
        """Rms of lines and noise in the reading [N m]."""
        return float(np.sqrt(self.before[0]))

    def load(self, scale: float) -> float:
        """Rms of the load's fluctuation in the reading [N m]."""
        return scale * float(np.sqrt(self.before[2]))

    def taken(self) -> float:
        """Share of the load's variance that the notches remove [1]."""
        return 1 - self.after[2] / self.before[2]

    def needed(self, cut: float) -> float | None:
        """Return the scale that gives a reduction ``cut`` [%]; None where no load gives it."""
        low, high = 0.0, _LARGEST
        if not self._cut(high) <= cut <= self._cut(low):
            return None
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._cut(middle) > cut else (low, middle)
        return 0.5 * (low + high)

    def _cut(self, scale: float) -> float:
        return float(self.cut(scale))


def superposed(rig: ReportRig, chain: Chain, occupancy: float, *, size: float) -> Superposed:
    """Return the covariances at an occupancy [%] and a size [m], from one run with and one without fluctuation.

    Both runs have the same random numbers, so their difference is the load's share of the reading. This is exact
    because the rig is linear there (no backlash, one direction), but not where the load would be negative.
    """
    whole, still = (rig.reading(occupancy, size, scale=scale) for scale in (1.0, 0.0))
    name = whole.torque_name()
    lines, both = still.torque(), whole.torque()
    parts = [
        (chain.apply(whole.with_values(name, values / whole.channels[name].si_per_unit)).torque())
        for values in (lines, both)
    ]
    return Superposed(float(both.mean()), _covariances(lines, both), _covariances(*parts))


def everywhere(
    rig: ReportRig, chain: Chain, places: tuple[tuple[float, float], ...], *, progress: Callable[[int, int, str], None]
) -> dict[tuple[float, float], Superposed]:
    """Return the covariances at each (occupancy [%], size [m])."""
    found = {}
    for number, (occupancy, size) in enumerate(places, start=1):
        found[occupancy, size] = superposed(rig, chain, occupancy, size=size)
        progress(number, len(places), f"{occupancy:g} %, {1e3 * size:g} mm")
    return found


def _covariances(lines: Floats, both: Floats) -> tuple[float, float, float]:
    load = both - lines
    first, second = lines - lines.mean(), load - load.mean()
    return tuple(float(np.mean(a * b)) for a, b in ((first, first), (first, second), (second, second)))  # type: ignore[return-value]


def _variance(parts: tuple[float, float, float], scale: float | Floats) -> float | Floats:
    return parts[0] + 2 * scale * parts[1] + scale**2 * parts[2]
