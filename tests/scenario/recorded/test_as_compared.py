"""What is known of a sensor is corrected once: in the recording, and not in the model again."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.benches import FREE, bench
from torquerig.linear_twin.quasi_static import quasi_static
from torquerig.linear_twin.twin import Twin
from torquerig.scenario.recorded.as_compared import as_compared
from torquerig.simulation.simulator import simulate

STATED = "scale: 1.5, zero: 0.2 N*m, mounting: reversed, sensitivity"


@pytest.mark.parametrize("known", ["sensitivity", STATED])
def test_the_model_predicts_the_corrected_mean_torque(known, tmp_path):
    scenario = bench(FREE.replace("sensitivity", known), tmp_path)
    made = simulate(scenario.rig, duration=2.0, seed=3, sample_rate=2000.0).without_truth()
    compared = as_compared(scenario, [made])
    (recording,) = compared.recordings
    twin = Twin(compared.scenario.rig.at(recording.run))
    expected = quasi_static(twin, speed=np.array([recording.run.speed]), acceleration=np.zeros(1)).sensor[0]
    assert recording.torque().mean() == pytest.approx(expected, rel=0.02)
