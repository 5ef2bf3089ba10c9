"""Three free parameters of the load, fitted to half of the published cells in the open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.study.reference_report.published import OCCUPANCIES, Cell
from torquerig.study.reference_report.superposed import Superposed

REFERENCE = 0.5e-3  # [m] size at which the fluctuation is stated
_SCALES, _EXPONENTS = (0.02, 4.0, 241), (-1.5, 2.5, 161)  # first, last, how many
_REFINED = 3

Places = Mapping[tuple[float, float], Superposed]


@dataclass(frozen=True, kw_only=True)
class Fit:
    """The load model's free parameters.

    Parameters
    ----------
    scale : float
        The load's fluctuation (hits and slow part alike) at 0.5 mm over the scenario's own [1].
    exponent : float
        The fluctuation goes with size to this power [1]; 0 in the scenario.
    occupancy : float
        Of Table IX [%], one of those of Table VIII; the report does not state it.
    misfit : float
        Rms difference over the fitted cells [percentage points].
    by_occupancy : dict of float to Fit-like tuple
        (scale, exponent, misfit) of the best fit for each occupancy that Table IX may have had.
    """

    scale: float
    exponent: float
    occupancy: float
    misfit: float
    by_occupancy: dict[float, tuple[float, float, float]]

    def scale_at(self, size: float) -> float:
        """Return by how much the load's fluctuation is scaled at a particle size [m]."""
        return float(self.scale * (size / REFERENCE) ** self.exponent)


def fitted(cells: Sequence[Cell], places: Places, *, size: float) -> Fit:
    """Return the fit to those of ``cells`` that it may see.

    Least squares in percentage points, by a grid of scale and exponent that is refined three times, for each
    occupancy that Table IX may have had.

    Parameters
    ----------
    places : mapping of (occupancy [%], size [m]) to Superposed
    size : float
        Particle size of Table VIII [m].
    """
    seen = [cell for cell in cells if cell.fitted]
    found = {occupancy: _best(seen, places, occupancy, size) for occupancy in OCCUPANCIES}
    best = min(found, key=lambda occupancy: found[occupancy][2])
    scale, exponent, misfit = found[best]
    return Fit(scale=scale, exponent=exponent, occupancy=best, misfit=misfit, by_occupancy=found)


def place_of(cell: Cell, *, occupancy: float, size: float) -> tuple[float, float]:
    """Return where a cell is simulated: what the report does not state is taken from ``occupancy`` and ``size``."""
    return (
        occupancy if cell.occupancy is None else cell.occupancy,
        size if cell.size is None else cell.size,
    )


def _best(seen: Sequence[Cell], places: Places, occupancy: float, size: float) -> tuple[float, float, float]:
    scales, exponents = np.geomspace(*_SCALES), np.linspace(*_EXPONENTS)
    for _ in range(1 + _REFINED):
        squares = np.zeros((scales.size, exponents.size))
        for cell in seen:
            place = place_of(cell, occupancy=occupancy, size=size)
            factors = scales[:, None] * (place[1] / REFERENCE) ** exponents[None, :]
            squares += (np.asarray(places[place].cut(factors)) - cell.cut) ** 2
        at_scale, at_exponent = np.unravel_index(int(squares.argmin()), squares.shape)
        scale, exponent = float(scales[at_scale]), float(exponents[at_exponent])
        ratio, step = float(scales[1] / scales[0]), float(exponents[1] - exponents[0])
        scales = np.geomspace(scale / ratio, scale * ratio, 21)
        exponents = np.linspace(exponent - step, exponent + step, 21)
    return scale, exponent, float(np.sqrt(squares.min() / len(seen)))
