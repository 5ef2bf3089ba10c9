"""Course of zero and gain of a reading over a recording; an empirical description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

Shape = Literal["step", "ramp", "settling"]


@dataclass(frozen=True, kw_only=True)
class Course:
    """``V (1 + g c(x)) + z c(x)`` with x the share of the recording that is over, in every recording alike.

    Parameters
    ----------
    shape : str
        ``step``: c is 0 before ``at`` and 1 after it. ``ramp``: 0 before it, then a straight line to 1 at the end.
        ``settling``: ``1 - exp(-x / at)``.
    at : float
        [1], between 0 and 1; for ``settling`` any positive number.
    zero : float
        z, in the unit of the torque channel.
    gain : float
        g [1].

    Notes
    -----
    An empirical description. Not valid where a change happens at another moment of each recording.
    """

    shape: Shape
    at: float
    zero: float = 0.0
    gain: float = 0.0

    def __post_init__(self) -> None:
        if not self.at > 0 or (self.shape != "settling" and not self.at < 1):
            raise InputError(f"a {self.shape} at {self.at} of a recording cannot be; write a share between 0 and 1")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the course on its torque channel."""
        if self.zero == 0 and self.gain == 0:
            return recording
        name = recording.torque_name()
        course = self.course(recording.time() / recording.duration)
        values = recording.channels[name].values
        return recording.with_values(name, values * (1 + self.gain * course) + self.zero * course)

    def course(self, share: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return c at shares of a recording [1]."""
        if self.shape == "step":
            return np.asarray(share > self.at, dtype=np.float64)
        if self.shape == "ramp":
            return np.asarray(np.maximum(share - self.at, 0.0) / (1 - self.at))
        return np.asarray(-np.expm1(-share / self.at))

    def mean(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the mean of c between two shares of a recording [1]; shapes alike."""
        return np.asarray((self._integral(high) - self._integral(low)) / (high - low))

    def _integral(self, share: NDArray[np.float64]) -> NDArray[np.float64]:
        over = np.maximum(share - self.at, 0.0)
        if self.shape == "step":
            return over
        if self.shape == "ramp":
            return 0.5 * over**2 / (1 - self.at)
        return share + self.at * np.exp(-share / self.at)
