"""Drift of the zero of a sensor or amplifier."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Drift:
    """V += s (1 - exp(-t / tau)), or s t / T over a recording of length T where tau is None; t from the first sample.

    Parameters
    ----------
    span : float
        s, in the unit of the torque channel; either sign.
    time_constant : float or None
        tau [s], > 0.

    Notes
    -----
    Source: handbook 6.3; a body that warms up follows the exponential (one thermal mass). Not valid where several
    masses warm up one after the other; a straight line is its beginning, for recordings much shorter than tau.
    """

    span: float
    time_constant: float | None = None

    def __post_init__(self) -> None:
        if self.time_constant is not None and not self.time_constant > 0:
            raise InputError(f"a drift with a time constant of {self.time_constant} s cannot be; write more than 0 s")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the drift on its torque channel."""
        if self.span == 0:
            return recording
        name, course = recording.torque_name(), self.course(recording.time(), recording.duration)
        return recording.with_values(name, recording.channels[name].values + course)

    def course(self, time: NDArray[np.float64], duration: float) -> NDArray[np.float64]:
        """Return the drift, in the unit of the torque channel, at times [s] of a recording of a duration [s]."""
        tau = self.time_constant
        return self.span * np.asarray(time / duration if tau is None else -np.expm1(-time / tau))
