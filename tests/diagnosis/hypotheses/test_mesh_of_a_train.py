"""In a train of gears a mesh is counted per turn of its own gear's output, and stated teeth say which gear's it is."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import gear_mesh
from torquerig.document import read_document
from torquerig.rig.assembly import Rig
from torquerig.scenario.reading import read_scenario

PLANETARY, BELT = 4.0, 2.5


def proposed(with_lines_left: Callable[..., Case], at: float) -> list[Any]:
    document = read_document(shipped_scenarios() / "two_stage_branch.yaml")
    return proposed_for(read_scenario(document, load_catalog(shipped_folder()), seed=1).rig, with_lines_left, at)


def proposed_for(rig: Rig, with_lines_left: Callable[..., Case], at: float) -> list[Any]:
    case = with_lines_left(at)
    model = SimpleNamespace(**{**vars(case.model), "rig": rig})
    train = cast("Case", SimpleNamespace(**{**vars(case), "nominal": rig, "model": model}))
    return [candidate.parts[0] for candidate in gear_mesh.propose(train)]


@pytest.mark.parametrize(("gear", "teeth", "turns"), [("planetary", 72, PLANETARY), ("belt", 50, PLANETARY * BELT)])
def test_stated_teeth_say_whose_mesh_it_is(
    gear: str, teeth: int, turns: float, with_lines_left: Callable[..., Case]
) -> None:
    found = proposed(with_lines_left, teeth / turns)
    assert {(part.gear, part.order_output) for part in found} == {(gear, float(teeth))}


def test_other_teeth_may_be_of_any_gear(with_lines_left: Callable[..., Case]) -> None:
    """Order 8 of the motor: 32 teeth of the first gear, or 80 of the second, or of a harmonic of either."""
    found = {(part.gear, part.order_output) for part in proposed(with_lines_left, 8.0)}
    assert {("planetary", 32.0), ("belt", 80.0)} <= found
    assert ("belt", 20.0) not in found, "which is 8 times the belt's own ratio, and no order of its output"


@pytest.mark.parametrize("measured", ["before", "behind"])
def test_a_gear_that_drives_up_has_whole_teeth_on_its_slower_side(
    measured: str, with_lines_left: Callable[..., Case], bench: Callable[..., Rig]
) -> None:
    """20 teeth drive 12, whose order is the output's own; a line at order 33 would be 33 teeth, 19.8 a turn of it."""
    found = proposed_for(bench(measured, wheel=12), with_lines_left, 20.0)
    assert {(part.gear, part.order_output) for part in found} == {("gears", 12.0)}
    found = proposed_for(bench(measured, wheel=12), with_lines_left, 33.0)
    assert ("gears", pytest.approx(19.8)) in [(part.gear, part.order_output) for part in found]
