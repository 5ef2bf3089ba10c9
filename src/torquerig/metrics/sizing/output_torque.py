"""Torque at a shaft of the chain, for each piece of the required motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class OutputTorque:
    """Torque [N m] and speed [rad/s] of the shaft at both ends of each piece, shape (pieces, 2).

    Parameters
    ----------
    duration : ndarray, shape (pieces,)
        [s]
    acceleration : ndarray, shape (pieces,)
        Of the shaft [rad/s^2].
    """

    duration: Floats
    speed: Floats
    torque: Floats
    acceleration: Floats

    @property
    def peak(self) -> float:
        """The largest torque of either sign [N m]."""
        return float(np.abs(self.torque).max())

    @property
    def alternates(self) -> bool:
        """Whether the torque changes sign within the cycle, by more than a thousandth of the peak."""
        least = 1e-3 * self.peak
        return bool(self.torque.max() > least and self.torque.min() < -least)

    @property
    def reverses(self) -> bool:
        """Whether the shaft turns in both directions."""
        return bool(self.speed.max() > 0 and self.speed.min() < 0)

    @property
    def rms(self) -> float:
        """Root of the mean square of the torque over the cycle [N m]."""
        first, last = self.torque.T
        return float(np.sqrt(np.sum(self.duration * (first**2 + first * last + last**2) / 3) / self.duration.sum()))

    @property
    def cubic_mean(self) -> float:
        """The constant torque with the same wear of bearings and teeth [N m].

        ``(sum |n| t |T|^3 / sum |n| t)^(1/3)``, the cubic mean by turns of makers of planetary gearboxes; with the mean
        of both ends of a piece. Zero where nothing turns.
        """
        turns = np.abs(self.speed).mean(axis=1) * self.duration
        if not turns.sum() > 0:
            return 0.0
        return float((np.sum(turns * np.abs(self.torque).mean(axis=1) ** 3) / turns.sum()) ** (1 / 3))
