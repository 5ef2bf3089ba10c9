"""What simulated gaps change in the expected features, and what rests tell of its width."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.benches import bench
from torquerig import mechanisms
from torquerig.inference.features.run_features import run_features
from torquerig.inference.gap_width import estimated_width
from torquerig.inference.measured_run import measured_runs
from torquerig.inference.prediction import gap_change
from torquerig.inference.prediction.expected_run import expected_line_power, expected_run
from torquerig.inference.prediction.gap_change import ARCMIN, WIDTHS, comes_near_zero, simulated_rests
from torquerig.parallel import parallel_processes
from torquerig.simulation.simulator import simulate

IDLE = """\
scenario: geared bench without a load
operating_point: {motor_speed: 600 rpm}
measured: sensor
rig:
  motor: {kind: motor, inertia: 0.002 kg*m^2, current_loop_bandwidth: 500 Hz, torque_limit: 20 N*m}
  controller: {kind: speed_controller, motor: motor, kp: 0.4 N*m*s/rad, ki: 1 N*m/rad}
  gearbox: {kind: gear, ratio: 4, stiffness: 3000 N*m/rad, damping: 1 N*m*s/rad, output_inertia: 0.002 kg*m^2}
  sensor: {kind: torque_sensor, stiffness: 1000 N*m/rad, damping: 0.2 N*m*s/rad, inertia: 0.0005 kg*m^2,
           sensitivity: 0.5 V/(N*m), bandwidth: 300 Hz, noise_rms: 0.002 V}
  drum: {kind: body, inertia: 0.01 kg*m^2, viscous: 0.01 N*m*s/rad}
  lines: {kind: torque_ripple, at: drum, group: mechanical, amplitudes: {1: 0.25 N*m, 2: 0.1 N*m}}
"""
LOADED = IDLE.replace("0.01 N*m*s/rad}\n  lines", "0.2 N*m*s/rad}\n  lines")
RATE = 1000.0


def seen_of(text, folder, gap=0.0):
    """Return the scenario's rig, and features of a run of it with a gap [arcmin]."""
    rig = bench(text, folder).rig
    truth = rig + mechanisms.Backlash(name="x", gear="gearbox", gap=gap * ARCMIN)
    recording = simulate(truth, duration=3.0, seed=3, sample_rate=RATE).without_truth()
    (run,) = measured_runs([recording], rig)
    return rig, run_features(run, [])


def opened(rig, gap):
    return rig + mechanisms.Backlash(name="gap", gear="gearbox", gap=gap * ARCMIN)


def off(model, seen):
    """Return the rms error of the expected logarithms of the densities [1]."""
    return float(np.sqrt(np.nanmean(np.log(seen.band_power / model.density) ** 2)))


def test_a_simulated_gap_explains_a_spectrum_that_the_twin_does_not(tmp_path):
    rig, seen = seen_of(IDLE, tmp_path, gap=10.0)
    without, with_gap = expected_run(rig, seen), expected_run(opened(rig, 10.0), seen)
    assert off(without, seen) > 2.0
    assert off(with_gap, seen) < 0.5 * off(without, seen)
    assert np.asarray(with_gap.density_error).max() > 0
    assert np.array_equal(expected_line_power(opened(rig, 10.0), seen), with_gap.line_power)


def test_a_vanishing_gap_changes_nothing(tmp_path):
    rig, seen = seen_of(IDLE, tmp_path)
    without, with_gap = expected_run(rig, seen), expected_run(opened(rig, 1e-6), seen)
    assert with_gap.density == pytest.approx(without.density, rel=1e-3)
    assert with_gap.level == pytest.approx(without.level, abs=1e-4)


def test_processes_share_the_features_of_simulated_runs(tmp_path, monkeypatch):
    rig, seen = seen_of(IDLE, tmp_path, gap=10.0)
    alone = expected_run(opened(rig, 10.0), seen)
    here, features_like = [], gap_change.features_like
    monkeypatch.setattr(gap_change, "features_like", lambda *args: here.append(args) or features_like(*args))
    seen.run.kept._answers.clear()
    with parallel_processes(2):
        shared = expected_run(opened(rig, 10.0), replace(seen))
    assert not here
    assert np.array_equal(shared.density, alone.density)


def test_a_gap_that_load_keeps_closed_is_not_simulated(tmp_path):
    rig, seen = seen_of(LOADED, tmp_path, gap=10.0)
    assert not comes_near_zero(seen.run)
    assert (expected_run(opened(rig, 10.0), seen).density == expected_run(rig, seen).density).all()


def test_the_rests_of_a_run_determine_the_width_of_its_gap(tmp_path):
    rig, seen = seen_of(IDLE, tmp_path, gap=10.0)
    part = mechanisms.Backlash(name="gap", gear="gearbox", gap=ARCMIN)
    rests = simulated_rests(rig, part, seen)
    assert rests is not None
    found = estimated_width([rests], np.array(WIDTHS), median=6.0, spread=1.2)
    assert found.low < 10.0 < found.high
    assert found.gain > 0.0


def test_rests_without_a_gap_count_against_it(tmp_path):
    rig, seen = seen_of(IDLE, tmp_path)
    rests = simulated_rests(rig, mechanisms.Backlash(name="gap", gear="gearbox", gap=ARCMIN), seen)
    assert rests is not None
    assert estimated_width([rests], np.array(WIDTHS), median=6.0, spread=1.2).gain < 0.0


def test_held_out_blocks_are_simulated_when_they_are_asked_for(tmp_path, monkeypatch):
    rig, seen = seen_of(IDLE, tmp_path, gap=10.0)
    made, like = list[object](), gap_change.features_like
    monkeypatch.setattr(gap_change, "features_like", lambda same, run: made.append(same) or like(same, run))
    expected_run(opened(rig, 10.0), seen)
    assert made
    assert all(each is seen for each in made)
    held = run_features(seen.run, [], held_out=True)
    assert (expected_run(opened(rig, 10.0), held).density != expected_run(rig, held).density).any()
