"""Counts of an incremental encoder on the motor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError
from torquerig.recordings.recording import Channel

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Encoder:
    """Counts whole steps of the motor angle as it is read: floor(angle * counts_per_rev / 2 pi), without wrapping.

    It adds the channel ``channel`` and does not change the torque.

    Parameters
    ----------
    counts_per_rev : int
        After edge multiplication [counts/rev], > 0.
    angle : str
        Name of the channel with the true motor angle [rad].
    channel : str
        Name of the channel to add.
    error : tuple of (order, amplitude, phase)
        The reading is ``angle + sum of amplitude cos(order angle + phase)``; amplitudes and phases in [rad].

    Notes
    -----
    Source: the definition of an incremental encoder; magnet or graduation error as in handbook 2.5.
    """

    counts_per_rev: int
    angle: str = "true_motor_angle_rad"
    channel: str = "encoder_count"
    error: tuple[tuple[float, float, float], ...] = ()

    def __post_init__(self) -> None:
        if self.counts_per_rev < 1:
            raise InputError(f"an encoder of {self.counts_per_rev} counts per turn cannot be; write at least 1")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the encoder's counts; RecordingError where the true angle is missing."""
        rad_per_count = 2 * np.pi / self.counts_per_rev
        angle = recording.channel(self.angle).in_si()
        reading = angle + sum((a * np.cos(order * angle + phase) for order, a, phase in self.error), np.zeros(1))
        counts = np.floor((reading if self.error else angle) / rad_per_count)
        return recording.with_channel(
            self.channel, Channel(values=counts, quantity="motor_angle", unit="count", si_per_unit=rad_per_count)
        )
