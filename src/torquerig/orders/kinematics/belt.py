"""Ratio, orders and free strands of a belt drive, from the lengths of belt and pulleys."""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, ceil, cos, pi

from torquerig.errors import InputError


@dataclass(frozen=True)
class Belt:
    """An open belt on two pulleys; circumferences and belt length in one unit, teeth of a toothed belt or metres.

    Parameters
    ----------
    pinion, wheel : float
        Pitch circumference of the input and of the output pulley, > 0; tooth counts where it is toothed.
    belt : float
        Length of the belt.
    toothed : bool
        Whether the three are tooth counts.

    Raises
    ------
    InputError
        When the belt is too short for the two pulleys; with the shortest possible length.

    Notes
    -----
    Source: handbook 3.7; ISO 5296 (belt lengths and pitches); for an open belt ``L = 2 C cos b + pi (D1 + D2)/2 +
    b (D2 - D1)``, ``sin b = (D2 - D1)/(2 C)`` (any text on machine elements).
    """

    pinion: float
    wheel: float
    belt: float
    toothed: bool = True

    def __post_init__(self) -> None:
        if min(self.pinion, self.wheel, self.belt) <= 0:
            raise InputError("pulleys and belt of a belt drive must be more than 0; correct the count that is not")
        shortest = self._length((self.pinion + self.wheel) / (2 * pi))
        if self.belt < shortest:
            unit, least = ("teeth", f"{ceil(shortest)}") if self.toothed else ("m", f"{shortest:.4g}")
            raise InputError(
                f"a belt of {self.belt:g} {unit} does not go round pulleys with rims of {self.pinion:g} and "
                f"{self.wheel:g} {unit}, which would touch; it needs at least {least} {unit}"
            )

    @property
    def ratio(self) -> float:
        """Turns of the input pulley per turn of the output pulley [1]."""
        return self.wheel / self.pinion

    @property
    def reverses(self) -> bool:
        """Whether the output turns opposite to the input; False for an open belt."""
        return False

    @property
    def mesh_order_in(self) -> float:
        """Belt teeth in mesh per turn of the input pulley [1/rev]."""
        return self.pinion

    @property
    def mesh_order_out(self) -> float:
        """Belt teeth in mesh per turn of the output pulley [1/rev]."""
        return self.wheel

    @property
    def belt_order_out(self) -> float:
        """Turns of the belt per turn of the output pulley [1/rev]: below both shafts."""
        return self.wheel / self.belt

    @property
    def spoken(self) -> str:
        """The drive in words."""
        return f"belt of {self.belt:g} round pulleys of {self.pinion:g} and {self.wheel:g}"

    def strand(self) -> float:
        """Return the length of one free strand, in the unit of the drive, from the belt's length."""
        low, high = (self.pinion + self.wheel) / (2 * pi), self.belt
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._length(middle) < self.belt else (low, middle)
        return low * cos(self._slant(low))

    def _slant(self, distance: float) -> float:
        return asin((self.wheel - self.pinion) / (2 * pi * distance))

    def _length(self, distance: float) -> float:
        """Return the length of the belt for pulleys whose axes are ``distance`` apart."""
        slant = self._slant(distance)
        return 2 * distance * cos(slant) + (self.pinion + self.wheel) / 2 + slant * (self.wheel - self.pinion) / pi
