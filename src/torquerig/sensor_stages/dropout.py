"""Dropouts: loss of the signal by a loose contact, slip ring or radio link."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Dropout:
    """V = level for ``duration``, at moments of a Poisson process of ``rate``; overlapping ones merge.

    Parameters
    ----------
    duration : float
        [s], >= 0.
    rate : float
        Mean number of dropouts per second [1/s], >= 0.
    level : float
        The reading during a dropout, in the unit of the torque channel: 0, or the supply rail.
    source : str
        Name of the cause, which determines the random moments.

    Notes
    -----
    Source: handbook 6.10. On a worn slip ring the moments are locked to the shaft's turn; that is not modelled.
    """

    duration: float
    rate: float
    level: float = 0.0
    source: str = "dropout"

    def __post_init__(self) -> None:
        if not (self.duration >= 0 and self.rate >= 0):
            raise InputError(
                f"dropouts of {self.duration} s at {self.rate} 1/s cannot be; write a duration and a rate of 0 or more"
            )

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with its torque channel at the level during dropouts."""
        rng = recording.random(f"moments {self.source}")
        # from one duration before the first sample, so that a recording may start within a dropout
        span = recording.duration + self.duration
        starts = rng.uniform(-self.duration, recording.duration, rng.poisson(self.rate * span))
        if starts.size == 0 or self.duration == 0:
            return recording
        name = recording.torque_name()
        first, last = (np.ceil((starts + shift) * recording.sample_rate) for shift in (0.0, self.duration))
        bounds = np.clip([first, last], 0, recording.samples).astype(np.int64)
        depth = np.zeros(recording.samples + 1, dtype=np.int64)
        np.add.at(depth, bounds[0], 1)
        np.add.at(depth, bounds[1], -1)
        lost = np.cumsum(depth)[:-1] > 0
        return recording.with_values(name, np.where(lost, self.level, recording.channels[name].values))
