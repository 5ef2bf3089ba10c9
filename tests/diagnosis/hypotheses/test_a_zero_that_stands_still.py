"""A zero that has moved before a run has begun is an offset, and no drift."""

from __future__ import annotations

import pytest

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.hypotheses import is_possible
from torquerig.mechanisms import SensorDrift
from torquerig.scenario.model import Scenario


@pytest.mark.parametrize(("constant", "possible"), [(0.01, False), (0.5, True), (None, True)])
def test_a_drift_takes_its_time(constant: float | None, possible: bool, wear_rig: Scenario) -> None:
    part = SensorDrift(name="sensor_drift", span=0.3, time_constant=constant)
    candidate = Candidate(mechanism="sensor_drift", parts=(part,), knobs=(), slow=True)
    assert is_possible(candidate, candidate.added_to(wear_rig.rig)) is possible
