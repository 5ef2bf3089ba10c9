"""A mesh of more teeth than small gears have is proposed, and must gain more than another name for the same line."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnose.case import Case
from torquerig.diagnose.hypotheses import gear_mesh
from torquerig.diagnose.looking.peaks import Peak
from torquerig.diagnose.looking.places import order
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize(
    ("line", "expected"),
    [(56.0, {280: 12.0, 140: 0.0}), (36.0, {180: 6.0, 90: 0.0}), (16.8, {84: 0.0, 42: 0.0})],
)
def test_many_teeth_cost(
    line: float, expected: dict[int, float], wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(gear_mesh, "line_factor", lambda case, rig, place: 1.0)
    peak = Peak(place=order(line), excess=50.0, runs=("run1",), speeds=1)
    case = SimpleNamespace(left=(peak,), nominal=wear_rig.rig, runs=(), model=SimpleNamespace(rig=wear_rig.rig))
    found: list[Any] = list(gear_mesh.propose(cast("Case", case)))
    assert {round(each.parts[0].order_output): each.price for each in found} == expected
