"""What the teeth of a gear stage fix: its ratio, the order of its mesh line, and whether its planets fit in."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sin

from torquerig.errors import InputError


@dataclass(frozen=True)
class Planetary:
    """Teeth of a planetary stage with a fixed ring, driven at the sun, taken off at the carrier.

    Parameters
    ----------
    sun, ring : int
        Tooth counts, > 0, ``ring`` > ``sun``.
    planets : int or None
        Number of equal planets; None where it is not known, and then the assembly is not checked.

    Raises
    ------
    InputError
        When equal planets cannot be put in, or would touch each other; names the nearest rings that work.

    Notes
    -----
    Source: handbook 4.2 (McFadden & Smith 1985; Kahraman & Blankenship 1994). The planets of a real set may be
    made with half a tooth more or less and profile shift (21/31/84), so their own count is not a condition here.
    """

    sun: int
    ring: int
    planets: int | None = None

    def __post_init__(self) -> None:
        if self.sun < 1 or self.ring <= self.sun:
            raise InputError(
                f"a planetary stage with sun {self.sun} and ring {self.ring} does not exist; the ring must have more "
                "teeth than the sun, and both at least one"
            )
        if self.planets is not None and not self._assembles(self.ring):
            near = [ring for step in range(1, 13) for ring in (self.ring - step, self.ring + step)]
            works = sorted(ring for ring in near if ring > self.sun and self._assembles(ring))[:4]
            raise InputError(
                f"{self.planets} equal planets do not fit between sun {self.sun} and ring {self.ring}: "
                f"(sun + ring) / planets must be whole and neighbours must clear; "
                + (f"rings that fit are {', '.join(map(str, works))}" if works else "take fewer planets")
            )

    @property
    def ratio(self) -> float:
        """Turns of the sun per turn of the carrier [1]."""
        return 1 + self.ring / self.sun

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the sun shaft [1/rev]."""
        return self.sun * self.ring / (self.sun + self.ring)

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the carrier [1/rev]: the teeth of the ring."""
        return float(self.ring)

    @property
    def spoken(self) -> str:
        """The stage in words."""
        return f"planetary stage, sun {self.sun} and ring {self.ring}"

    def _assembles(self, ring: int) -> bool:
        planets = self.planets or 1
        planet = (ring - self.sun) / 2
        clears = planets < 2 or (self.sun + planet) * sin(pi / planets) > planet + 2
        return planet >= 1 and (self.sun + ring) % planets == 0 and clears


@dataclass(frozen=True)
class Spur:
    """Teeth of a fixed-axis pair or toothed belt: ``pinion`` drives ``wheel`` (handbook 4.1, 3.7)."""

    pinion: int
    wheel: int

    def __post_init__(self) -> None:
        if self.pinion < 1 or self.wheel < 1:
            raise InputError(
                f"a pair of {self.pinion} and {self.wheel} teeth does not exist; both must be at least one"
            )

    @property
    def ratio(self) -> float:
        """Turns of the pinion per turn of the wheel [1]."""
        return self.wheel / self.pinion

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the pinion [1/rev]."""
        return float(self.pinion)

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the wheel [1/rev]."""
        return float(self.wheel)

    @property
    def spoken(self) -> str:
        """The pair in words."""
        return f"pair of {self.pinion} and {self.wheel} teeth"


Teeth = Planetary | Spur
