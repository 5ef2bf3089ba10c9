"""Which field of a cogging holds which order."""

from __future__ import annotations

import pytest

from torquerig.mechanisms import Cogging

RIG = Cogging(name="cogging", slots=12, pole_pairs=7)


@pytest.mark.parametrize(
    ("order", "field"),
    [(84, "native"), (12, "unequal_magnets"), (14, "unequal_teeth"), (42, "further"), (24, "further")],
)
def test_an_order_stands_in_its_field(order: int, field: str) -> None:
    assert RIG.held_by(order) == (field, order if field == "further" else None)
    assert RIG.with_amplitudes({order: 0.2}).amplitudes() == {order: 0.2}


def test_amplitudes_are_put_where_they_are_read() -> None:
    wanted = {84: 0.1, 12: 0.02, 14: 0.03, 42: 0.004}
    part = RIG.with_amplitudes(wanted)
    assert part.amplitudes() == wanted
    assert part.with_amplitudes({12: 0.5}).amplitudes() == {12: 0.5}, "and no others remain"


def test_where_slots_are_a_multiple_of_the_poles_the_native_order_is_the_slots_own() -> None:
    assert Cogging(name="cogging", slots=12, pole_pairs=2).held_by(12) == ("native", None)
