"""Which pairs of pole pairs and slots a three-phase motor can have at all."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from math import gcd


def has_winding(pole_pairs: int, slots: int) -> bool:
    """Say whether three balanced phases can be wound into ``slots`` [1] for ``pole_pairs`` [1].

    The phases are balanced when each takes a whole number of spokes of the star of slots: ``Q / (3 gcd(Q, p))``.
    Holds for windings that fill every slot; a motor with empty slots may exist all the same.

    Source: Bianchi & Bolognani, IEEE Trans. Industry Applications 38(5), 2002 (star of slots).
    """
    return slots % (3 * gcd(slots, pole_pairs)) == 0


def winding_pairs(pole_pairs: Iterable[int], slots: Iterable[int]) -> list[tuple[int, int]]:
    """Return the pairs that have a winding, in the order of the arguments."""
    return [pair for pair in product(pole_pairs, slots) if has_winding(*pair)]
