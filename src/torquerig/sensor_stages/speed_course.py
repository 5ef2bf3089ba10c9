"""Torque in a reading that follows the speed by no law; an empirical description without a cause."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError

if TYPE_CHECKING:
    from torquerig.recordings.recording import Recording

SpeedShape = Literal["kink", "window"]

_WIDTH = 0.07  # [1] one sigma of a window, relative to its middle: the narrowest that a ramp of some blocks resolves


@dataclass(frozen=True, kw_only=True)
class SpeedCourse:
    """``T += s c(|w|) sign(w)``, w the speed of the motor.

    Parameters
    ----------
    shape : str
        ``kink``: c is 0 below ``at`` and ``|w| / at - 1`` above it. ``window``: ``exp(-(|w| / at - 1)^2 / (2 b^2))``
        with b = 0.07.
    at : float
        Speed of the motor [rad/s], > 0.
    size : float
        s [N m]; either sign.
    angle : str
        Name of the channel with the true angle.

    Notes
    -----
    An empirical description. Not valid where the torque follows anything but the speed, such as a temperature.
    """

    shape: SpeedShape
    at: float
    size: float
    angle: str = "true_motor_angle_rad"

    def __post_init__(self) -> None:
        if not self.at > 0:
            raise InputError(f"a {self.shape} at a speed of {self.at} rad/s cannot be; write more than 0 rad/s")

    def apply(self, recording: Recording) -> Recording:
        """Return ``recording`` with the torque on its torque channel."""
        if self.size == 0:
            return recording
        name = recording.torque_name()
        channel = recording.channels[name]
        speed = np.gradient(recording.channel(self.angle).in_si(), 1 / recording.sample_rate)
        return recording.with_values(name, channel.values + self.torque(speed) / channel.si_per_unit)

    def torque(self, speed: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the torque at speeds of the motor [N m]; shapes alike."""
        beyond = np.abs(speed) / self.at - 1
        course = np.maximum(beyond, 0.0) if self.shape == "kink" else np.exp(-0.5 * np.square(beyond / _WIDTH))
        return np.asarray(self.size * np.sign(speed) * course)
