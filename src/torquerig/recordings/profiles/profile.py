"""What every profile answers: how fast the motor is to turn at a time, and with which load."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.corners import Corners


class SpeedProfile(Protocol):
    """The set-point of the motor speed over one run.

    ``top`` is the set-point that the test sheet states [rad/s] and ``duration`` the length of the recording [s]; a
    profile with times and speeds of its own needs neither.
    """

    @property
    def word(self) -> str:
        """The word by which a test sheet names it."""
        ...

    @property
    def length(self) -> float:
        """How long it can run [s]; infinite where it takes the length of the recording or repeats without end."""
        ...

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point of the motor speed [rad/s] at each ``time`` [s] from the start of the recording."""
        ...

    def load(self, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return the mean load at the wear part [N m] at each ``time`` [s]; None leaves it to the rig."""
        ...

    def corners(self, *, top: float, duration: float) -> Corners:
        """Return the recording, or one cycle of what repeats, as straight lines."""
        ...
