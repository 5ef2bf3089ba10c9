"""A line whose amplitude changes slowly is found by the pairs of its side lines."""

from __future__ import annotations

import pytest

from torquerig.inference.additions.line_family import reach_of
from torquerig.inference.places import order

SWELLING = [8.4 + step for step in (-0.29, -0.145, 0.0, 0.036, 0.145, 0.29, 0.8)]


def test_side_lines_reach_as_far_as_their_pairs():
    places = [order(at) for at in SWELLING]
    assert reach_of(order(8.4), places, slowest=1.0) == pytest.approx(0.29, abs=0.01)


@pytest.mark.parametrize(
    ("orders", "slowest"),
    [
        ([8.11, 8.255, 8.4, 8.545, 8.69], 0.25),  # 0.145 is more than half of a turn of the slowest shaft
        ([8.2, 8.4, 8.6], 1.0),  # one pair may be chance
        ([8.2, 8.25, 8.4, 8.5], 1.0),
        ([8.384, 8.392, 8.4, 8.408, 8.416], 1.0),  # no block separates these
    ],
)
def test_other_lines_are_no_side_lines(orders, slowest):
    assert reach_of(order(8.4), [order(at) for at in orders], slowest=slowest) == 0.0
