"""The shape of a phase's back-EMF over the electrical angle: harmonics, or a trapezoid.

Angle zero is where the EMF of phase a rises through zero; phases b and c follow 120 electrical degrees behind.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from math import pi, sin
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from torquerig.machines.checks import check_fields
from torquerig.parameter import Parameter

Floats = NDArray[np.float64]


class BackEmf(ABC):
    """A unit shape ``s(angle)``: the EMF is flux linkage x electrical speed x s."""

    @property
    @abstractmethod
    def fundamental(self) -> float:
        """Amplitude of the first harmonic of the shape [1], which sinusoidal currents work against."""

    @abstractmethod
    def shape(self, angle: Floats) -> Floats:
        """Return the unit shape at the electrical ``angle`` [rad], any shape of array."""

    @abstractmethod
    def kernel_rows(self) -> tuple[float, Floats, Floats]:
        """Return flat angle [rad] (0 for harmonics), orders and amplitudes, in the layout of the kernel."""


@dataclass(frozen=True)
class HarmonicEmf(BackEmf):
    """``s = sum_h a_h sin(h angle)``, all harmonics in phase with the fundamental; a negative a_h is turned by 180 deg.

    Only odd orders: an even one would need north and south poles of different shape. Multiples of three raise the star
    point and make neither current nor torque.
    """

    amplitudes: dict[int, float] = field(default_factory=lambda: {1: 1.0})

    def __post_init__(self) -> None:
        if not self.amplitudes.get(1, 0.0) > 0:
            raise ValueError("amplitudes: a back-EMF needs its fundamental; write 1: 1.0 first")
        for order, amplitude in self.amplitudes.items():
            if order < 1 or order % 2 == 0:
                raise ValueError(
                    f"amplitudes: a back-EMF has odd orders only, {order} is none; write 5, 7, 11, 13, ..."
                )
            if not np.isfinite(amplitude):
                raise ValueError(f"amplitudes: order {order} is {amplitude}; write a finite share of the fundamental")

    def __hash__(self) -> int:
        return hash(frozenset(self.amplitudes.items()))

    @property
    def fundamental(self) -> float:
        """Amplitude of the first harmonic [1]."""
        return self.amplitudes[1]

    def shape(self, angle: Floats) -> Floats:
        """Return the sum of the harmonics."""
        waves = [amplitude * np.sin(order * angle) for order, amplitude in sorted(self.amplitudes.items())]
        return np.asarray(np.sum(waves, axis=0), dtype=np.float64)

    def kernel_rows(self) -> tuple[float, Floats, Floats]:
        """Return no flat angle, and the harmonics in rising order."""
        rows = sorted(self.amplitudes.items())
        return 0.0, np.array([float(order) for order, _ in rows]), np.array([amplitude for _, amplitude in rows])


@dataclass(frozen=True)
class TrapezoidalEmf(BackEmf):
    """Flat at one over ``flat_angle`` [electrical rad], straight between; 120 degrees is the ideal one."""

    flat_angle: Annotated[float, Parameter("rad", "flat top", above=0, high=0.999 * pi)] = 2 * pi / 3

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def fundamental(self) -> float:
        """Amplitude of the first harmonic, 4 sin(r) / (pi r) with r the half width of a ramp [1]."""
        ramp = 0.5 * (pi - self.flat_angle)
        return 4 * sin(ramp) / (pi * ramp)

    def shape(self, angle: Floats) -> Floats:
        """Return the clipped triangle."""
        triangle = 0.5 * pi - np.abs(np.mod(angle + 0.5 * pi, 2 * pi) - pi)
        return np.asarray(np.clip(2 * triangle / (pi - self.flat_angle), -1, 1), dtype=np.float64)

    def kernel_rows(self) -> tuple[float, Floats, Floats]:
        """Return the flat angle and no harmonics."""
        return self.flat_angle, np.zeros(0), np.zeros(0)
