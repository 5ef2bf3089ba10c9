"""A mesh of more teeth than small gears have is proposed, and must gain more than another name for the same line."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from torquerig.diagnose.case import Candidate, Case
from torquerig.diagnose.hypotheses import gear_mesh, is_possible
from torquerig.mechanisms import GearMesh
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize(
    ("line", "expected"),
    [(56.0, {280: 12.0, 140: 0.0}), (36.0, {180: 6.0, 90: 0.0}), (16.8, {84: 0.0, 42: 0.0})],
)
def test_many_teeth_cost(line: float, expected: dict[int, float], with_lines_left: Callable[..., Case]) -> None:
    found: list[Any] = list(gear_mesh.propose(with_lines_left(line)))
    assert {round(each.parts[0].order_output): each.price for each in found} == expected


@pytest.mark.parametrize(("sizes", "possible"), [((5e-8, 2e-5), False), ((2e-5, 1e-5), True), ((4e-6, 2e-5), True)])
def test_teeth_that_do_not_show_themselves_are_twice_as_many(
    sizes: tuple[float, ...], possible: bool, wear_rig: Scenario
) -> None:
    part = GearMesh(name="gear_mesh", gear="gearbox", order_output=140.0, transmission_error=sizes)
    candidate = Candidate(mechanism="gear_mesh", parts=(part,), knobs=())
    assert is_possible(candidate, candidate.added_to(wear_rig.rig)) is possible
