"""Printed results of the report's filter, and which of these cells a fit uses."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Table = Literal["VIII", "IX"]


@dataclass(frozen=True)
class Cell:
    """A published reduction of the standard deviation by the report's filter.

    Parameters
    ----------
    table : {"VIII", "IX"}
    occupancy : float or None
        [%]; None where the report does not state it (Table IX).
    size : float
        Particle size [m]; that of Table VIII is not stated; the scenario's is used.
    cut : float
        [%].
    fitted : bool
        Whether the fit uses it; the others are held out.
    """

    table: Table
    occupancy: float | None
    size: float | None
    cut: float
    fitted: bool

    @property
    def shown(self) -> str:
        """The name of the row in the report."""
        return f"{self.occupancy:g} %" if self.table == "VIII" else f"{1e3 * (self.size or 0):g} mm"


# report, section 4.3.1; every other cell of each table is fitted, beginning with the first: chosen before any fit
CELLS: tuple[Cell, ...] = (
    Cell("VIII", 5.0, None, 68.0, True),
    Cell("VIII", 11.0, None, 20.0, False),
    Cell("VIII", 15.0, None, 29.0, True),
    Cell("VIII", 21.0, None, 41.0, False),
    Cell("IX", None, 0.25e-3, 45.0, True),
    Cell("IX", None, 0.32e-3, 30.0, False),
    Cell("IX", None, 0.50e-3, 48.0, True),
    Cell("IX", None, 0.78e-3, 23.0, False),
    Cell("IX", None, 0.98e-3, 24.0, True),
)
OCCUPANCIES = (5.0, 11.0, 15.0, 21.0)
"""Occupancies of Table VIII [%]; that of Table IX is not stated."""

MECHANICAL_DROP = 59.0
"""Drop of the amplitude of mechanical noise with the load [%] (section 4.1, Figures 4.2 and 4.3); held out."""
