"""What a hidden effect or stranger may change: the train, pushes on it, the sensed torque, the volts, the file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from proof.fleet.courses import Courses
from proof.fleet.train import Train

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Motion:
    """One run over its frames, settling included: time from the recording's begin [s], torque, angles, speed, rates."""

    time: Floats
    torque: Floats
    motor_angle: Floats
    output_angle: Floats
    output_speed: Floats
    rate: float
    duration: float


@dataclass(frozen=True)
class Place:
    """Where an effect shows: domain and axis of the diagnosis's JSON, position and relative width."""

    domain: str
    axis: str
    at: float
    width: float = 0.01

    def as_dict(self) -> dict[str, Any]:
        """Return the place for the answer."""
        return {"domain": self.domain, "axis": self.axis, "at": self.at, "width": self.width}


@dataclass(frozen=True)
class Effect:
    """An effect that the scenario does not have; every hook returns what it got unless the effect changes it.

    Parameters
    ----------
    part : str
        Part of the scenario in or at which it sits.
    """

    kind: ClassVar[str] = ""
    mechanical: ClassVar[bool] = True
    """Whether the train moves otherwise because of it, so that its recordings need an integration of their own."""
    in_samples: ClassVar[bool] = False
    """Whether it changes single samples, so that these show it whatever their spectrum."""

    part: str

    def parameters(self) -> dict[str, float | None]:
        """Return the true parameters by their names in the contract."""
        return {}

    def places(self) -> tuple[Place, ...]:
        """Return where it shows."""
        return ()

    def on_train(self, train: Train) -> Train:
        """Return the changed train."""
        return train

    def pushes(self, motion: Motion, rng: np.random.Generator) -> dict[str, Floats]:
        """Return torques over the frames from the motion without the effect, by the names of `Courses`."""
        return {}

    def on_torque(self, torque: Floats, motion: Motion, rng: np.random.Generator) -> Floats:
        """Return the sensed torque over the frames [N m]."""
        return torque

    def on_bandwidth(self, bandwidth: float) -> float:
        """Return the amplifier's bandwidth [Hz]."""
        return bandwidth

    def on_volts(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Return the volts of the samples in front of the converter."""
        return volts

    def on_codes(self, volts: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Return the volts of the samples behind the converter."""
        return volts

    def on_angle(self, angle: Floats, time: Floats, rng: np.random.Generator) -> Floats:
        """Return the motor angle as the encoder reads it [rad]."""
        return angle


__all__ = ["Courses", "Effect", "Floats", "Motion", "Place"]
