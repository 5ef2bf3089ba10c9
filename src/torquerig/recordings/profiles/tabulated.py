"""Times and speeds from a table, once or again and again."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.corners import Corners
from torquerig.recordings.profiles.gaps import refuse_short


@dataclass(frozen=True, kw_only=True)
class Tabulated:
    """Straight lines between the rows of a table, ``repeats`` times (None: as long as the run lasts).

    Parameters
    ----------
    rows : Corners
        Speeds of the motor.
    word : str
        The word by which a test sheet names it.
    """

    rows: Corners
    repeats: int | None = 1
    word: str = "csv"

    @property
    def length(self) -> float:
        """How long it can run [s]."""
        return inf if self.repeats is None else self.repeats * self.rows.length

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point at each time [rad/s]; InputError where the table ends before the recording."""
        refuse_short(self.word, self.length, duration=duration)
        return self.rows.speed_at(self._within(time))

    def load(self, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return the load at each time [N m]; None where the table states none."""
        return self.rows.load_at(self._within(time))

    def corners(self, *, top: float, duration: float) -> Corners:
        """Return the table, once."""
        return self.rows

    def _within(self, time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the time since the cycle began; the very end of the last cycle is its end."""
        return np.asarray(np.where(time >= self.length, self.rows.length, np.mod(time, self.rows.length)))
