"""The density that a model expects between its lines, also in a mode that is narrower than a band."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.benches import PUMP, bench, recorded
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data
from torquerig.inference.measured_run import measured_runs
from torquerig.inference.model_density import model_densities
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.linear_twin.twin import Twin

SHARP = PUMP.replace("damping: 0.5 N*m*s/rad", "damping: 0.03 N*m*s/rad").replace("kp: 0.4", "kp: 0.02")


def test_the_density_in_a_sharp_mode_is_that_of_the_mode(tmp_path):
    assert SHARP != PUMP
    scenario = bench(SHARP, tmp_path)
    seen = run_features(measured_runs(recorded(scenario, [], runs=((800, 0),)), scenario.rig)[0], [])
    data, model = Data.of([seen]), expected_run(scenario.rig, seen)
    fit = SimpleNamespace(fitted_rig=scenario.rig, expected=(model,), gains=np.zeros(data.shapes[0].count))
    twin = Twin(scenario.rig.at(seen.run.run))
    frequency = np.linspace(50.0, 400.0, 7001)
    load = twin.load_power(frequency)
    peak = int(np.argmax(load))
    band = int(np.argmin(np.abs(np.log(seen.bands.middle / frequency[peak]))))
    found = model_densities(fit, data)[0](frequency)
    assert load[peak] > 2 * model.density[0, band], "the mode is narrower than the band"
    assert found[peak] == pytest.approx(load[peak], rel=0.25)
    away = int(np.argmin(np.abs(frequency - 1.4 * frequency[peak])))
    assert found[away] == pytest.approx(np.interp(frequency[away], seen.bands.middle, model.density[0]), rel=0.25)
