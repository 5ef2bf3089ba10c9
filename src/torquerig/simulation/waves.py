"""The cosines that a rig needs, from few sine calls: one per commensurate family, its multiples by products."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

import numpy as np

from torquerig.simulation.arrays import RUNGS, Waves

LARGEST_DENOMINATOR = 1000  # orders such as 16.8 or 3.572 are fractions of this size; others get a sine of their own
LARGEST_MULTIPLE = 4096


@dataclass
class WaveTable:
    """Collects (node, order) pairs and gives each the slot where the kernel will find its cosine and sine.

    The multiples 1, 2, 3, ... of a base are a ladder that the kernel climbs ``RUNGS`` at a time without looking back
    into memory; multiples beyond it are products of two earlier slots, in as few stages as there are.
    """

    bases: list[tuple[int, float]] = field(default_factory=list)
    ladders: list[range] = field(default_factory=list)  # the slots of each base: multiples 1, 2, 3, ...
    products: list[tuple[int, int]] = field(default_factory=list)
    slots: dict[tuple[int, float], int] = field(default_factory=dict)

    @classmethod
    def of(cls, wanted: Iterable[tuple[int, float]]) -> WaveTable:
        """Return the table for all wanted (node, order) pairs."""
        table = cls()
        by_node: dict[int, set[float]] = {}
        for node, order in wanted:
            by_node.setdefault(node, set()).add(order)
        plans = [(node, *plan) for node, orders in sorted(by_node.items()) for plan in families(orders)]
        for node, base, multiples in plans:  # the kernel climbs all ladders first, so they come first
            start, length = table.rungs, ladder_length(multiples.values())
            table.bases.append((node, base))
            table.ladders.append(range(start, start + length))
        for (node, _, multiples), ladder in zip(plans, table.ladders, strict=True):
            known = dict(enumerate(ladder, start=1))
            for order, multiple in sorted(multiples.items(), key=lambda item: item[1]):
                table.slots[(node, order)] = table._make(known, multiple)
        return table

    @property
    def rungs(self) -> int:
        """How many slots the ladders fill."""
        return self.ladders[-1].stop if self.ladders else 0

    def _make(self, known: dict[int, int], multiple: int) -> int:
        if multiple in known:
            return known[multiple]
        # halves first: the chain of products is as short as it can be
        for part in sorted(known, key=lambda one: abs(2 * one - multiple)):
            if multiple - part in known:
                parts = (part, multiple - part)
                break
        else:
            parts = (multiple - multiple // 2, multiple // 2)
        factors = self._make(known, parts[0]), self._make(known, parts[1])
        slot = self.rungs + len(self.products)
        self.products.append(factors)
        known[multiple] = slot
        return slot

    def lowered(self) -> Waves:
        """Return the arrays for the kernel."""
        return Waves(
            base_node=np.array([node for node, _ in self.bases], dtype=np.uint64),
            base_order=np.array([order for _, order in self.bases], dtype=np.float64),
            ladder=np.array([0, *(ladder.stop for ladder in self.ladders)], dtype=np.uint64),
            first=np.array([first for first, _ in self.products], dtype=np.uint64),
            second=np.array([second for _, second in self.products], dtype=np.uint64),
        )


def orders_of(waves: Waves) -> list[tuple[int, float]]:
    """Return the node and the order of every slot."""
    found = [
        (int(node), float(order) * multiple)
        for row, (node, order) in enumerate(zip(waves.base_node, waves.base_order, strict=True))
        for multiple in range(1, int(waves.ladder[row + 1] - waves.ladder[row]) + 1)
    ]
    for first, second in zip(waves.first, waves.second, strict=True):
        found.append((found[first][0], found[first][1] + found[second][1]))
    return found


def ladder_length(multiples: Iterable[int]) -> int:
    """Return how far the ladder goes: as long as one rung in ``RUNGS`` is wanted, rounded up to whole climbs."""
    within = [multiple for count, multiple in enumerate(sorted(multiples), start=1) if count * RUNGS >= multiple]
    return RUNGS * -(-max(within, default=1) // RUNGS)


def families(orders: set[float]) -> list[tuple[float, dict[float, int]]]:
    """Return (base order, {order: multiple}) families that cover all orders."""
    fractions = {order: Fraction(order).limit_denominator(LARGEST_DENOMINATOR) for order in orders if order > 0}
    exact = {order: fraction for order, fraction in fractions.items() if abs(float(fraction) - order) < 1e-12 * order}
    lonely = [(order, {order: 1}) for order in sorted(orders) if order not in exact]
    if not exact:
        return lonely
    below = lcm(*(fraction.denominator for fraction in exact.values()))
    above = gcd(*(int(fraction * below) for fraction in exact.values()))
    base = Fraction(above, below)
    multiples = {order: int(fraction / base) for order, fraction in exact.items()}
    if max(multiples.values()) > LARGEST_MULTIPLE:
        return lonely + [(order, {order: 1}) for order in sorted(exact)]
    return [*lonely, (float(base), multiples)]
