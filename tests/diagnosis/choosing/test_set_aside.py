"""Why each mechanism was not named, in one sentence."""

from __future__ import annotations

from typing import cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.search import Tried
from torquerig.diagnosis.choosing.set_aside import CONTRACT, set_aside
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.mechanisms import Backlash, QuadraticDrag
from torquerig.rig.assembly import Part
from torquerig.scenario.model import Scenario

NOT_FITTED = cast(Calibrated, None)  # nothing was tried, so that no model is asked


def reasons(wear_rig: Scenario, *parts: Part) -> dict[str, str]:
    rig = wear_rig.rig
    for part in parts:
        rig = rig + part
    case = Case(nominal=rig, runs=(), seen=(), model=NOT_FITTED, left=())
    return set_aside(case, Tried((), ()), known=("sensor_drift",))


def test_each_mechanism_that_is_not_named_has_its_reason(wear_rig: Scenario) -> None:
    assert set(reasons(wear_rig)) == CONTRACT - {"sensor_drift"}


@pytest.mark.parametrize(
    ("name", "part"),
    [("quadratic_drag", QuadraticDrag(name="drag", at="wear_part", coefficient=1e-4)),
     ("backlash", Backlash(name="gap", gear="gearbox", gap=1e-3))],
)  # fmt: skip
def test_what_the_scenario_has_is_said_to_be_there(wear_rig: Scenario, name: str, part: Part) -> None:
    without, having = reasons(wear_rig), reasons(wear_rig, part)
    assert having[name] == f"the scenario already contains it; a second one: {without[name]}"
    assert {**having, name: without[name]} == without
