"""The practice recordings of ../shared: made by another program, 12 s at 25 kHz, named as their answers say.

A minute each, so only .ci/full runs them; ``python -m proof`` runs all of them.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.diagnosis.engine import diagnose
from torquerig.recordings.files import read_recording
from torquerig.scenario.model import Scenario

PRACTICE = Path(__file__).resolve().parents[3] / ".." / "shared" / "practice"
pytestmark = [
    pytest.mark.skipif(not PRACTICE.exists(), reason="shared/practice is not beside this checkout"),
    pytest.mark.full,
]

ANSWERS: dict[str, tuple[str | None, dict[str, float]]] = {
    "practice1": ("gear_mesh", {"order_output": 72.0, "transmission_error_rad": 5.028e-5}),
    "practice7": ("blade_pass", {"order_output": 6.0, "amplitude_Nm": 0.498}),
    "practice8": (None, {}),
}


@pytest.mark.parametrize("case", ANSWERS)
def test_a_practice_case_is_named_as_its_answer_says(case: str, wear_rig: Scenario) -> None:
    name, parameters = ANSWERS[case]
    made = diagnose(
        wear_rig, [read_recording(path) for path in sorted((PRACTICE / case).glob("run?.parquet"))]
    ).diagnosis
    assert [finding.mechanism for finding in made.findings] == ([] if name is None else [name])
    assert made.verdict == ("adequate" if name is None else "missing_physics")
    for parameter, value in parameters.items():
        # the answer's program and the simulator differ in integrator, contact and load
        assert made.findings[0].parameters[parameter].value == pytest.approx(value, rel=0.1)
