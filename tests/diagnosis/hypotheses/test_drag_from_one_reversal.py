"""A drag shows in one run that turns back, beside one at a steady speed."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import quadratic_drag
from torquerig.scenario.model import Scenario


@pytest.mark.parametrize(("course", "proposed"), [(None, 0), ((-60.0, -5.0, 30.0, 60.0), 1), ((-60.0, 60.0), 0)])
def test_the_blocks_of_a_run_that_turns_back_show_many_speeds(
    course: tuple[float, ...] | None, proposed: int, wear_rig: Scenario
) -> None:
    steady = SimpleNamespace(speed=np.full((4, 3), 60.0), turning=None)
    turning = SimpleNamespace(speed=np.zeros((0, 3)), turning=SimpleNamespace(speed=np.array(course)))
    seen = [steady] if course is None else [steady, turning]
    case = SimpleNamespace(
        nominal=wear_rig.rig, seen=seen, model=SimpleNamespace(rig=wear_rig.rig), misfit_of=lambda rig: 0.0,
        nominal_with_accepted=lambda: wear_rig.rig,
    )  # fmt: skip
    assert len(list(quadratic_drag.propose(cast("Case", case)))) == proposed
