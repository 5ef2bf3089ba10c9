"""Three free parameters of the load, fitted to half of the published cells."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from torquerig.study.reference_report.published import OCCUPANCIES, Cell
from torquerig.study.reference_report.superposition import Superposed

REFERENCE = 0.5e-3  # [m] size at which the fluctuation is stated
_SCALES, _EXPONENTS = (0.02, 4.0, 241), (-1.5, 2.5, 161)  # first, last, number
_REFINED = 3

Places = Mapping[tuple[float, float], Superposed]


@dataclass(frozen=True, kw_only=True)
class Fit:
    """The load model's free parameters.

    Parameters
    ----------
    scale : float
        The load's fluctuation (hits and slow part alike) at 0.5 mm over that of the scenario [1].
    exponent : float
        The fluctuation goes with size to this power [1]; 0 in the scenario.
    occupancy : float
        Of Table IX [%], one of those of Table VIII; the report does not state it.
    residual : float
        Rms difference over the fitted cells [percentage points].
    by_occupancy : dict of float to Fit-like tuple
        (scale, exponent, residual) of the best fit for each occupancy that Table IX may have.
    """

    scale: float
    exponent: float
    occupancy: float
    residual: float
    by_occupancy: dict[float, tuple[float, float, float]]

    def scale_at(self, size: float) -> float:
        """Return the scale of the load's fluctuation at a particle size [m]."""
        return float(self.scale * (size / REFERENCE) ** self.exponent)


def fitted(cells: Sequence[Cell], places: Places, *, size: float) -> Fit:
    """Return the fit to the cells that are not held out.

    Least squares in percentage points, by a grid of scale and exponent that is refined three times, for each
    occupancy that Table IX may have.

    Parameters
    ----------
    places : mapping of (occupancy [%], size [m]) to Superposed
    size : float
        Particle size of Table VIII [m].
    """
    used = [cell for cell in cells if cell.fitted]
    found = {occupancy: _best(used, places, occupancy, size) for occupancy in OCCUPANCIES}
    best = min(found, key=lambda occupancy: found[occupancy][2])
    scale, exponent, residual = found[best]
    return Fit(scale=scale, exponent=exponent, occupancy=best, residual=residual, by_occupancy=found)


def place_of(cell: Cell, *, occupancy: float, size: float) -> tuple[float, float]:
    """Return the conditions of a cell; those that the report does not state are ``occupancy`` and ``size``."""
    return (
        occupancy if cell.occupancy is None else cell.occupancy,
        size if cell.size is None else cell.size,
    )


def _best(used: Sequence[Cell], places: Places, occupancy: float, size: float) -> tuple[float, float, float]:
    scales, exponents = np.geomspace(*_SCALES), np.linspace(*_EXPONENTS)
    for _ in range(1 + _REFINED):
        squares = np.zeros((scales.size, exponents.size))
        for cell in used:
            place = place_of(cell, occupancy=occupancy, size=size)
            factors = scales[:, None] * (place[1] / REFERENCE) ** exponents[None, :]
            squares += (np.asarray(places[place].cut(factors)) - cell.cut) ** 2
        at_scale, at_exponent = np.unravel_index(int(squares.argmin()), squares.shape)
        scale, exponent = float(scales[at_scale]), float(exponents[at_exponent])
        ratio, step = float(scales[1] / scales[0]), float(exponents[1] - exponents[0])
        scales = np.geomspace(scale / ratio, scale * ratio, 21)
        exponents = np.linspace(exponent - step, exponent + step, 21)
    return scale, exponent, float(np.sqrt(squares.min() / len(used)))
