"""Lines of a rig that has none of its own tell its set-points' error, where they all are whole orders but for it."""

from __future__ import annotations

import pytest

from torquerig.diagnosis.looking.lines_left import whole_by_one_factor


def test_lines_off_by_one_share_are_whole() -> None:
    assert whole_by_one_factor([6.9696, 13.9392, 20.9088], 1.0) == [7.0, 14.0, 21.0]
    assert whole_by_one_factor([2 * 1.004 / 5, 6 * 1.004 / 5], 5.0) == pytest.approx([0.4, 1.2])


@pytest.mark.parametrize(
    "orders",
    [
        [6.9696],  # one line may stand anywhere
        [6.9696, 13.7],  # not by one share
        [3.58, 7.16],  # a bearing
        [6.8, 13.6],  # no drive is 3 % off
        [7.0, 14.0],  # whole as they are
        [],
    ],
)
def test_others_stay_where_they_are(orders: list[float]) -> None:
    assert whole_by_one_factor(orders, 1.0) == orders
