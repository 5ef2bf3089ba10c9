"""Pole pairs and slots with a balanced three-phase winding, and the nearest such pairs."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from math import gcd

NEAREST = 4  # pairs that a refusal names
REACH = 6  # how far from the written counts they are looked for


def has_winding(pole_pairs: int, slots: int) -> bool:
    """Return whether three balanced phases can be wound into ``slots`` [1] for ``pole_pairs`` [1].

    The phases are balanced when each takes a whole number of spokes of the star of slots: ``Q / (3 gcd(Q, p))``.
    Holds for windings that fill every slot; a motor with empty slots may exist all the same.

    Source: Bianchi & Bolognani, IEEE Trans. Industry Applications 38(5), 2002 (star of slots).
    """
    return slots % (3 * gcd(slots, pole_pairs)) == 0


def winding_pairs(pole_pairs: Iterable[int], slots: Iterable[int]) -> list[tuple[int, int]]:
    """Return the pairs that have a winding, in the order of the arguments."""
    return [pair for pair in product(pole_pairs, slots) if has_winding(*pair)]


def nearest_windings(pole_pairs: int, slots: int) -> tuple[tuple[int, int], ...]:
    """Return the pairs (pole pairs, slots) nearest to the written ones that have a winding, fewest changes first.

    A change is one slot or one pole pair, since either may be the misprint. Pairs whose fundamental winding factor is
    poor, fewer than half a slot per pole or more than six, are left out.
    """
    near = winding_pairs(
        range(max(1, pole_pairs - REACH), pole_pairs + REACH + 1), range(max(3, slots - REACH), slots + REACH + 1)
    )
    usual = [(p, q) for p, q in near if 0.5 * 2 * p <= q <= 6 * 2 * p]
    return tuple(sorted(usual, key=lambda pair: (abs(pair[0] - pole_pairs) + abs(pair[1] - slots), pair))[:NEAREST])


def no_winding(pole_pairs: int, slots: int) -> str:
    """Return the error text for a pair without balanced winding, with the nearest pairs that have one."""
    near = nearest_windings(pole_pairs, slots)
    remedy = ", ".join(f"{q} slots with {p} pole pair{'s' * (p > 1)}" for p, q in near)
    return (
        f"no three-phase winding exists for {slots} slots and {pole_pairs} pole pairs, because slots / (3 x greatest "
        f"common divisor) = {slots}/{3 * gcd(slots, pole_pairs)} is not whole; "
        + (f"the nearest that work: {remedy}" if remedy else "write fewer pole pairs")
    )
