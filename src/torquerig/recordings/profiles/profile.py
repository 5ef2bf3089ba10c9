"""The interface of a profile: the set-point of the motor speed and the load over time."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from torquerig.recordings.profiles.breakpoints import Breakpoints


class SpeedProfile(Protocol):
    """The set-point of the motor speed over one run.

    ``top`` is the set-point that the test conditions state [rad/s] and ``duration`` the length of the recording [s].
    A tabulated profile needs neither.
    """

    @property
    def name(self) -> str:
        """The name in a sidecar."""
        ...

    @property
    def length(self) -> float:
        """The longest run [s] that it covers; infinite where it takes the recording's length or repeats without end."""
        ...

    def speed(self, time: NDArray[np.float64], *, top: float, duration: float) -> NDArray[np.float64]:
        """Return the set-point of the motor speed [rad/s] at each ``time`` [s] from the start of the recording."""
        ...

    def load(self, time: NDArray[np.float64]) -> NDArray[np.float64] | None:
        """Return the mean load at the wear part [N m] at each ``time`` [s]; None: the rig's load applies."""
        ...

    def breakpoints(self, *, top: float, duration: float) -> Breakpoints:
        """Return the profile over the recording, or one cycle of a repeated one, as straight lines."""
        ...
