"""Bending cross-talk: bending moments in a torque sensor's reading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording


@dataclass(frozen=True, kw_only=True)
class Crosstalk:
    """T += A cos(theta + phi_1) + B cos(2 theta + phi_2) + C w^2 cos(theta + phi_3), theta of the sensor's shaft.

    Parameters
    ----------
    once, twice : float
        A and B [N m], >= 0: a bending moment fixed in space, read by a turning bridge; an oval body.
    once_by_speed_squared : float
        C [N m s^2/rad^2], >= 0: the bending moment of an unbalance.
    turns : float
        Turns of the sensor's shaft per turn of ``angle`` [1].
    angle : str
        Name of the channel with the true angle.
    source : str
        Name of the cause, which determines the random phases.

    Notes
    -----
    Source: handbook 6.4, 3.1. The moment of an unbalance turns with the shaft and would read as a constant in a
    straight bridge; C holds for the part that a bearing's uneven stiffness turns back into the space-fixed frame.
    """

    once: float
    twice: float = 0.0
    once_by_speed_squared: float = 0.0
    turns: float = 1.0
    angle: str = "true_motor_angle_rad"
    source: str = "bending"

    def __post_init__(self) -> None:
        if min(self.once, self.twice, self.once_by_speed_squared) < 0:
            raise InputError("a cross-talk of negative amplitude cannot be; write 0 or more, the phase is drawn")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the bending lines on its torque channel."""
        if not (self.once or self.twice or self.once_by_speed_squared):
            return recording
        name = recording.torque_name()
        channel = recording.channels[name]
        theta = recording.channel(self.angle).in_si() * self.turns
        speed = np.gradient(theta, 1 / recording.sample_rate)
        first, second, third = recording.random(f"phases {self.source}").uniform(0, 2 * np.pi, 3)
        torque = self.once * np.cos(theta + first) + self.twice * np.cos(2 * theta + second)
        torque += self.once_by_speed_squared * speed**2 * np.cos(theta + third)
        return recording.with_values(name, channel.values + torque / channel.si_per_unit)
