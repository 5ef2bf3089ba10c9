"""A hum that one run shows near a whole order of the output stands on none, where the angle was measured."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import blade_pass, commutation_ripple, gear_mesh


@pytest.mark.parametrize(("off", "teeth"), [(0.0, {18}), (0.0056, set[int]())])
def test_teeth_and_blades_stand_on_whole_orders(
    off: float, teeth: set[int], with_lines_left: Callable[..., Case]
) -> None:
    case = with_lines_left(3.6 + off)
    assert {round(one.parts[0].order_output) for one in gear_mesh.propose(case)} == teeth  # type: ignore[attr-defined]
    assert bool([one for one in blade_pass.propose(case) if one.place is not None]) is bool(teeth)


@pytest.mark.parametrize(("off", "proposed"), [(0.0, True), (0.0056, False)])
def test_ripple_stands_on_whole_orders_of_the_motor(
    off: float, proposed: bool, with_lines_left: Callable[..., Case]
) -> None:
    case = with_lines_left(28.0 + off)
    assert any(one.place == case.left[0].place for one in commutation_ripple.propose(case)) is proposed
