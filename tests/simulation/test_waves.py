"""The waves that the kernel makes are those that were asked for, however they are made."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.simulation.kernel.ladder import climb
from torquerig.simulation.waves import WaveTable, orders_of

LADDER = tuple(6.0 * k for k in range(1, 13))
ASKED = {
    "dense": LADDER,
    "gaps": (6.0, 18.0, 84.0),
    "far": (1.0, 84.0, 168.0, 252.0),
    "fractions": (3.572, 16.8, 33.6, 1.0),
    "lonely": (np.pi, np.e, 1.0),
    "none": (),
}


@pytest.mark.parametrize("orders", ASKED.values(), ids=ASKED)
def test_every_slot_holds_the_cosine_and_sine_of_its_order(orders: tuple[float, ...]) -> None:
    wanted = [(0, order) for order in orders] + [(2, 2 * order) for order in orders]
    table = WaveTable.of(wanted)
    waves, theta = table.lowered(), np.array([0.7, 0.0, -41.3, 0.0])
    made = np.empty((2, table.rungs + len(table.products)))
    climb.py_func(waves, theta, *made)
    turned = orders_of(waves)
    assert len(turned) == made.shape[1]
    for node, order in wanted:
        slot = table.slots[(node, order)]
        assert turned[slot] == (node, pytest.approx(order, rel=1e-12))
        # each product adds a rounding of 2^-53 or two; the angle itself is that uncertain times its size
        angle = order * theta[node]
        assert made[:, slot] == pytest.approx([np.cos(angle), np.sin(angle)], abs=3e-15 * (4 + abs(angle)))


def test_neighbouring_multiples_need_no_products() -> None:
    table = WaveTable.of((0, order) for order in LADDER)
    assert table.ladders == [range(12)]
    assert not table.products


def test_a_far_multiple_costs_few_products() -> None:
    """Order 84 beside order 1 by halves: 84, 42, 21, then 11 + 10, 6 + 5, 3 + 3 and so on from a ladder of four."""
    table = WaveTable.of([(0, 1.0), (0, 84.0)])
    assert table.ladders == [range(4)]
    assert len(table.products) <= 2 * np.log2(84)
