"""A speed that wanders or bends asks for torque, which is no noise of the sensor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.benches import FREE, bench
from torquerig.inference.features.run_features import run_features
from torquerig.inference.measured_run import measured_runs
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run
from torquerig.linear_twin.twin import Twin
from torquerig.simulation.simulator import simulate

RATE, DURATION = 1000.0, 12.0  # [Hz], [s]
SLOW = 8.0  # [Hz] below it the torque of a moved speed exceeds the sensor's noise


def seen_and_rig(folder, *, rpm, profile, wander, stated):
    scenario = bench(FREE, folder)
    run = replace(scenario.rig.run, speed=rpm * np.pi / 30, profile=profile)
    rig = scenario.rig.at(run)
    made = replace(simulate(rig, duration=DURATION, seed=3, sample_rate=RATE, wander=wander), name="run1.parquet")
    measured = replace(measured_runs([replace(made, run=run).without_truth()], rig)[0], wander=stated)
    known = sorted({order(line.order) for line in Twin(rig).lines()})
    return run_features(measured, known, held_out=None), rig


def slow_ratio(seen, rig):
    """Return measured over expected density in the bands below ``SLOW``, weighed by their counts."""
    expected = expected_run(rig, seen).density
    shown = np.isfinite(seen.band_power) & (seen.bands.middle < SLOW)
    assert shown.any()
    logs = np.log(seen.band_power[shown] / expected[shown]) + 0.5 / seen.band_count[shown]
    return float(np.exp(np.average(logs, weights=seen.band_count[shown])))


@pytest.mark.parametrize(("rpm", "wander"), [(1200, 1e-3), (3000, 5e-4), (1200, 3e-3)])
def test_a_wandering_speed_makes_the_torque_that_is_expected(tmp_path, rpm, wander):
    seen, rig = seen_and_rig(tmp_path, rpm=rpm, profile="steady", wander=wander, stated=wander)
    assert slow_ratio(seen, rig) == pytest.approx(1.0, rel=0.35)  # some 100 values: 0.1 sd
    unstated = replace(seen, run=replace(seen.run, wander=0.0))
    assert slow_ratio(unstated, rig) > 2.5


@pytest.mark.parametrize("profile", ["ramp", "reversal"])
def test_a_profile_that_bends_makes_the_torque_that_is_expected(tmp_path, profile):
    seen, rig = seen_and_rig(tmp_path, rpm=3000, profile=profile, wander=0.0, stated=5e-4)
    with_course = expected_run(rig, seen).density
    steady = replace(seen.run, recording=replace(seen.run.recording, run=replace(seen.run.run, profile="steady")))
    without = expected_run(rig, replace(seen, run=replace(steady, wander=0.0))).density
    bent = (with_course > 10 * without) & np.isfinite(seen.band_power)
    assert bent.any()
    assert np.median(np.abs(np.log(seen.band_power[bent] / with_course[bent]))) < 1.0
