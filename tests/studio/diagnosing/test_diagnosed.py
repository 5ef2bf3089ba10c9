"""A diagnosis as the studio shows it, of a rig whose motion was measured."""

from __future__ import annotations

import numpy as np
import pytest

from tests.moved_rigs import CARRIAGE, recorded
from torquerig.recordings.files import write_recording
from torquerig.studio.diagnosing.diagnosed import diagnosed
from torquerig.studio.diagnosing.question import DiagnosisQuestion


@pytest.mark.long
def test_the_likelihood_compares_a_measured_motion_in_the_studio(tmp_path):
    scenario, recording, stages = tmp_path / "rig.yaml", tmp_path / "run.csv", []
    write_recording(recorded(lambda time, position, speed: 20.0 * np.sign(speed)), recording)
    question = DiagnosisQuestion(scenario, CARRIAGE, (recording,))
    shown = diagnosed(question, lambda *, stage: stages.append(stage))
    assert [one["mechanism"] for one in shown.data["findings"]] == ["stribeck_friction"]
    assert any("The error on held-out data changes from" in one for one in shown.answer.sentences)
    assert shown.pictures
    assert "friction" in str(shown.model)
    assert stages[0] == "reading the recordings"
