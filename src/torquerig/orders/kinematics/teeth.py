"""Ratio, mesh orders and torque harmonics of a gear stage, from its tooth counts."""

from __future__ import annotations

from cmath import exp
from dataclasses import dataclass
from math import gcd, pi

from torquerig.errors import InputError
from torquerig.orders.kinematics.belt import Belt
from torquerig.orders.kinematics.planetary_assembly import (
    Fixed,
    assembly_fault,
    assembly_remedy,
    nearest_sets,
    stage_ratio,
)
from torquerig.orders.kinematics.worm import Worm

MOST_TEETH = 10_000  # the largest slewing rings have 1000


@dataclass(frozen=True)
class Planetary:
    """Teeth of a planetary stage; by default sun in, carrier out, ring fixed.

    Parameters
    ----------
    sun, ring : int
        Tooth counts, > 0, ``ring`` > ``sun``.
    planets : int or None
        Number of equal planets; None where unknown, and then the assembly is not checked.
    planet : int or None
        Teeth of a planet, where they are known.
    fixed : {"ring", "carrier", "sun"}
        The fixed member: the ring (sun in, carrier out), the carrier (sun in, ring out, reversed) or the sun (ring in,
        carrier out).

    Raises
    ------
    InputError
        When such a set cannot be assembled; with the nearest sets that can, for the same ratio.

    Notes
    -----
    Source: handbook 4.2 (McFadden & Smith 1985; Kahraman & Blankenship 1994; Parker 2000). Assembly conditions:
    ``orders/kinematics/planetary_assembly.py``.
    """

    sun: int
    ring: int
    planets: int | None = None
    planet: int | None = None
    fixed: Fixed = "ring"

    def __post_init__(self) -> None:
        if self.sun < 1 or self.ring <= self.sun:
            raise InputError(
                f"a planetary stage with sun {self.sun} and ring {self.ring} does not exist; the ring must have more "
                "teeth than the sun, and both at least one"
            )
        if self.ring > MOST_TEETH:
            raise InputError(f"a ring of {self.ring} teeth does not exist; the most are {MOST_TEETH}")
        if self.planets is not None and self.planets < 1:
            raise InputError(f"{self.planets} planets are not possible; write at least 1, or leave planets out")
        if self.fixed not in ("ring", "carrier", "sun"):
            raise InputError(f"fixed: {self.fixed!r} is not a member of a planetary stage; write ring, carrier or sun")
        if reason := assembly_fault(self.sun, self.ring, self.planets, self.planet):
            ratio = stage_ratio(self.sun, self.ring, self.fixed)
            near = nearest_sets(self.sun, self.ring, self.planets, ratio=ratio, fixed=self.fixed)
            set_of = f"{self.planets} equal planets do" if self.planets else "the planets do"
            remedy = assembly_remedy(near, ratio, self.fixed)
            raise InputError(f"{set_of} not fit between sun {self.sun} and ring {self.ring}: {reason}; {remedy}")

    @property
    def ratio(self) -> float:
        """Turns of the input per turn of the output, without sign [1]."""
        return stage_ratio(self.sun, self.ring, self.fixed)

    @property
    def reverses(self) -> bool:
        """Whether the output turns opposite to the input."""
        return self.fixed == "carrier"

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the input shaft [1/rev]."""
        return float(self.sun) if self.fixed == "carrier" else self.sun * self.ring / (self.sun + self.ring)

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the output shaft [1/rev]: the teeth of the ring, or of a fixed sun."""
        return float(self.sun if self.fixed == "sun" else self.ring)

    @property
    def lever_teeth(self) -> int:
        """The lever arm of a tooth error at the output, in teeth of half a module times cos(pressure angle) [1].

        From ``r_s (ws - wc) + r_r (wr - wc) = d(error)/dt``, with the planet rolling on both.
        """
        return self.ring if self.fixed == "carrier" else self.sun + self.ring

    @property
    def spoken(self) -> str:
        """The stage in words."""
        held = "" if self.fixed == "ring" else f", {self.fixed} fixed"
        return f"planetary stage, sun {self.sun} and ring {self.ring}{held}"

    def torque_share(self, order: int, shares: tuple[float, ...] = ()) -> float:
        """Return the share of a line of a whole output order that remains in the torque [1].

        ``abs(sum_k w_k exp(2 pi i order k / n))``: planet k is at the angle 2 pi k / n, so that of n equally loaded
        planets only orders that are multiples of n remain. ``shares`` are the w_k, 1/n each by default.
        """
        count = self.planets or 1
        weights = shares or (1 / count,) * count
        return abs(sum(share * exp(2j * pi * (order * k % count) / count) for k, share in enumerate(weights)))

    def torque_harmonics(self, highest: int = 4) -> tuple[int, ...]:
        """Return which of the first ``highest`` mesh harmonics remain in the torque; the others act as lateral forces.

        Harmonic l remains where l zs / n is whole (equally, by the assembly, l zr / n): Parker 2000, JSV 236(4).
        """
        return tuple(h for h in range(1, highest + 1) if h * self.sun % (self.planets or 1) == 0)

    def fault_orders(self) -> dict[str, float]:
        """Return the output orders [1/rev] of one damaged tooth by member; empty where the planets are unknown."""
        if self.planets is None:
            return {}
        planet = self.planet or (self.ring - self.sun) / 2
        mesh = self.mesh_order_out
        passes = {"sun": self.planets * mesh / self.sun, "ring": self.planets * mesh / self.ring}
        return {**passes, "planet": 2 * mesh / planet}


@dataclass(frozen=True)
class Spur:
    """Teeth of a fixed-axis pair: ``pinion`` drives ``wheel`` (handbook 4.1), a ring where it is ``internal``."""

    pinion: int
    wheel: int
    internal: bool = False

    def __post_init__(self) -> None:
        if self.pinion < 1 or self.wheel < 1:
            raise InputError(
                f"a pair of {self.pinion} and {self.wheel} teeth does not exist; both must be at least one"
            )
        if self.internal and self.wheel <= self.pinion:
            raise InputError(
                f"a pinion of {self.pinion} does not fit into a ring of {self.wheel} teeth; write a wheel of at least "
                f"{self.pinion + 1}"
            )

    @property
    def ratio(self) -> float:
        """Turns of the pinion per turn of the wheel, without sign [1]."""
        return self.wheel / self.pinion

    @property
    def reverses(self) -> bool:
        """Whether the wheel turns opposite to the pinion."""
        return not self.internal

    @property
    def mesh_order_in(self) -> float:
        """Mesh periods per turn of the pinion [1/rev]."""
        return float(self.pinion)

    @property
    def mesh_order_out(self) -> float:
        """Mesh periods per turn of the wheel [1/rev]."""
        return float(self.wheel)

    @property
    def lever_teeth(self) -> int:
        """The lever arm of a tooth error at the wheel, in teeth of half a module [1]."""
        return self.wheel

    @property
    def hunting_order_out(self) -> float:
        """Meetings of the same two teeth per turn of the wheel [1/rev]: gcd / pinion."""
        return gcd(self.pinion, self.wheel) / self.pinion

    @property
    def spoken(self) -> str:
        """The pair in words."""
        return f"pair of {self.pinion} and {self.wheel} teeth"


Teeth = Planetary | Spur | Belt | Worm
