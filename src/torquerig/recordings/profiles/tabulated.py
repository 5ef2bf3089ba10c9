"""A profile from a table of times and speeds, once or repeated."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.table_checks import refuse_short


@dataclass(frozen=True, kw_only=True)
class Tabulated:
    """Straight lines between the rows of a table, ``repeats`` times (None: as long as the run lasts).

    Parameters
    ----------
    rows : Breakpoints
        Speeds of the motor.
    name : str
        The name in a sidecar.
    """

    rows: Breakpoints
    repeats: int | None = 1
    name: str = "csv"

    @property
    def length(self) -> float:
        """The longest run [s] that it covers."""
        return inf if self.repeats is None else self.repeats * self.rows.length

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]; InputError where the table ends before the recording."""
        refuse_short(self.name, self.length, duration=duration)
        return self.rows.speed_at(self._within(time))

    def load(self, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return the load at each time [N m]; None where the table states none."""
        return self.rows.load_at(self._within(time))

    def breakpoints(self, *, top: float, duration: float) -> Breakpoints:
        """Return one cycle of the table."""
        return self.rows

    def _within(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the time since the start of the cycle [s]; at the end of the last cycle its length."""
        return np.asarray(np.where(time >= self.length, self.rows.length, np.mod(time, self.rows.length)))
