"""Which cosines a rig needs, made with few sine calls: one per commensurate family, products for the rest."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from math import gcd, lcm

import numpy as np

from torquerig.simulate.arrays import Waves

LARGEST_DENOMINATOR = 1000  # orders such as 16.8 or 3.572 are fractions of this size; others get a sine of their own
LARGEST_MULTIPLE = 4096


@dataclass
class WaveTable:
    """Collects (node, order) pairs and gives each the slot where the kernel will find its cosine and sine."""

    bases: list[tuple[int, float]] = field(default_factory=list)
    products: list[tuple[int, int]] = field(default_factory=list)
    slots: dict[tuple[int, float], int] = field(default_factory=dict)

    @classmethod
    def of(cls, wanted: Iterable[tuple[int, float]]) -> WaveTable:
        """Return the table for all wanted (node, order) pairs."""
        table = cls()
        by_node: dict[int, set[float]] = {}
        for node, order in wanted:
            by_node.setdefault(node, set()).add(order)
        plans = [(node, *plan) for node, orders in sorted(by_node.items()) for plan in _families(orders)]
        for node, base, _ in plans:  # the kernel fills all bases first, so they come first
            table.slots[(node, base)] = len(table.bases)
            table.bases.append((node, base))
        for node, base, multiples in plans:
            known = {1: table.slots[(node, base)]}
            for order, multiple in sorted(multiples.items(), key=lambda item: item[1]):
                table.slots[(node, order)] = table._make(known, multiple)
        return table

    def _make(self, known: dict[int, int], multiple: int) -> int:
        if multiple in known:
            return known[multiple]
        for larger in sorted(known, reverse=True):
            if larger < multiple and multiple - larger in known:
                parts = (larger, multiple - larger)
                break
        else:
            parts = (multiple - multiple // 2, multiple // 2)
        factors = self._make(known, parts[0]), self._make(known, parts[1])
        slot = len(self.bases) + len(self.products)
        self.products.append(factors)
        known[multiple] = slot
        return slot

    def lowered(self) -> Waves:
        """Return the arrays for the kernel."""
        return Waves(
            base_node=np.array([node for node, _ in self.bases], dtype=np.uint64),
            base_order=np.array([order for _, order in self.bases], dtype=np.float64),
            first=np.array([first for first, _ in self.products], dtype=np.uint64),
            second=np.array([second for _, second in self.products], dtype=np.uint64),
        )


def _families(orders: set[float]) -> list[tuple[float, dict[float, int]]]:
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
