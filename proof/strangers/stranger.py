"""An effect that no mechanism of the library describes, with one place and one size by which it can be located."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from proof.fleet.effect import Effect, Floats, Place
from proof.fleet.response import sensed_per_torque
from proof.fleet.setting import Setting


@dataclass(frozen=True)
class Stranger(Effect):
    """A stranger.

    Parameters
    ----------
    at : float
        Where it shows on its axis.
    size : float
        Its torque [N m], or its share where it changes a gain or a stiffness.
    phase : float
        Of its wave [rad].
    more : tuple of float
        Further numbers of the kind, as its docstring says.
    """

    domain: ClassVar[str] = "order"
    axis: ClassVar[str] = "output_shaft"
    width: ClassVar[float] = 0.01
    acts_as: ClassVar[str] = "torque at PART"
    at: float
    size: float
    phase: float = 0.0
    more: tuple[float, ...] = ()

    def places(self) -> tuple[Place, ...]:
        """Return the place."""
        return (Place(self.domain, self.axis, self.at, self.width),)

    def parameters(self) -> dict[str, float | None]:
        """Return place and size."""
        return {"at": self.at, "size": self.size}

    @classmethod
    def draw(cls, rng: np.random.Generator, setting: Setting) -> Any:
        """Return a drawn stranger of this kind for a rig, or None where the rig cannot have it."""
        raise NotImplementedError


def load_size(rng: np.random.Generator, setting: Setting, frequency: float) -> float:
    """Draw the torque [N m] on the body of the load that makes a line of this frequency [Hz] at the sensor."""
    gain = abs(sensed_per_torque(setting.train, max(frequency, 0.5), -1, speed=setting.output_speed))
    return float(min(setting.line_size(rng) * 3.0 / max(gain, 0.05), setting.torque))


def any_phase(rng: np.random.Generator) -> float:
    """Draw a phase [rad]."""
    return float(rng.uniform(0.0, 2.0 * np.pi))


def uneven_order(rng: np.random.Generator, low: float, high: float) -> float:
    """Draw an order that is no small fraction: at least 0.08 from every multiple of a half and 0.05 of a third."""
    while True:
        order = float(rng.uniform(low, high))
        if abs(2.0 * order - round(2.0 * order)) > 0.16 and abs(3.0 * order - round(3.0 * order)) > 0.15:
            return order


def burst(time: Floats, start: float, end: float, soft: float = 0.05) -> Floats:
    """Return 1 between two times and 0 outside, with soft edges [s]."""
    return np.asarray(0.5 * (np.tanh((time - start) / soft) - np.tanh((time - end) / soft)))
