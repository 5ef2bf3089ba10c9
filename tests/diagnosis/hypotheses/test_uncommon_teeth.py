"""A mesh of more teeth than small gears have is proposed, and must gain more than another name for the same line."""

from __future__ import annotations

from collections.abc import Callable
from math import log
from typing import Any

import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.hypotheses import gear_mesh, is_possible
from torquerig.mechanisms import GearMesh
from torquerig.scenario.model import Scenario


@pytest.mark.parametrize(
    ("line", "expected"),
    [(58.0, {290: 12.0, 145: 0.0}), (38.0, {190: 6.0, 95: 0.0}), (16.8, {84: 0.0, 42: 0.0, 28: 0.0})],
)
def test_many_teeth_cost(line: float, expected: dict[int, float], with_lines_left: Callable[..., Case]) -> None:
    found: list[Any] = list(gear_mesh.propose(with_lines_left(line)))
    assert {round(each.parts[0].order_output): each.price for each in found} == expected


def test_teeth_pay_where_slots_and_poles_put_cogging(with_lines_left: Callable[..., Case]) -> None:
    """Of 141 numbers of teeth behind 5:1 four put their first line on a multiple of 12 or 14, nine, eight the next."""
    found: list[Any] = list(gear_mesh.propose(with_lines_left(42.0)))
    prices = {round(each.parts[0].order_output): each.price for each in found}
    second, third = pytest.approx(2 * log(141 / 9)), pytest.approx(2 * log(141 / 8))
    assert prices == {210: pytest.approx(12.0 + 2 * log(141 / 4)), 105: second, 70: third}


@pytest.mark.parametrize(("sizes", "possible"), [((5e-8, 2e-5), False), ((2e-5, 1e-5), True), ((4e-6, 2e-5), True)])
def test_teeth_that_do_not_show_themselves_are_twice_as_many(
    sizes: tuple[float, ...], possible: bool, wear_rig: Scenario
) -> None:
    part = GearMesh(name="gear_mesh", gear="gearbox", order_output=140.0, transmission_error=sizes)
    candidate = Candidate(mechanism="gear_mesh", parts=(part,), knobs=())
    assert is_possible(candidate, candidate.added_to(wear_rig.rig)) is possible
