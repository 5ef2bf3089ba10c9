"""Another pair of teeth: found by the orders of the lines, and never where the stated pair is right."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from tests.inference.pump_bench import pump_scenario, recorded, simulated
from torquerig.inference.engine import prepared
from torquerig.inference.readings import other_teeth
from torquerig.inference.readings.order_comb import order_spectrum
from torquerig.inference.readings.teeth import toothed_stages, with_pair
from torquerig.recordings.recording import Channel

GEAR = """\
  gearbox: {kind: fixed_axis_gear, teeth: {pinion: 17, wheel: 51}, stiffness: 3000 N*m/rad,
            damping: 0.5 N*m*s/rad, output_inertia: 0.001 kg*m^2}
"""
LINES = """\
  mesh: {kind: gear_mesh, gear: gearbox, order_output: 51, transmission_error: [0.00005 rad]}
  blades: {kind: blade_pass, at: pump, order_output: 3, amplitude: 0.3 N*m}
"""


@pytest.fixture(scope="module")
def geared(tmp_path_factory):
    """Return a bench with a gear between motor and sensor, and its runs with an encoder of 1024 counts."""
    made = pump_scenario(tmp_path_factory.mktemp("geared"), LINES, before_sensor=GEAR)
    runs = []
    for truth, run in zip(simulated(made), recorded(made), strict=True):
        counts = np.floor(truth.channels["true_motor_angle_rad"].values / (2 * np.pi) * 1024)
        channel = Channel(values=counts, quantity="motor_angle", unit="count", si_per_unit=2 * np.pi / 1024)
        runs.append(run.with_channel("encoder_count", channel))
    return made, runs


def with_teeth(scenario, pair):
    (stage,) = toothed_stages(scenario.rig)
    return replace(scenario, rig=with_pair(scenario.rig, stage, pair))


@pytest.mark.long
@pytest.mark.parametrize(
    ("stated", "kind", "estimated"),
    [((17, 52), "teeth", 51), ((18, 51), "teeth", 17), ((16, 60), "gear_ratio", 3.0)],
)
def test_a_wrong_pair_is_reported_with_the_right_one(geared, stated, kind, estimated):
    scenario, runs = geared
    (fault,) = prepared(with_teeth(scenario, stated), runs).setup
    assert kind in (fault.kind, *fault.equivalent_to)
    assert fault.of == "gearbox"
    assert fault.estimated == pytest.approx(estimated)
    low, high = fault.interval
    assert low <= estimated <= high


@pytest.mark.parametrize(
    ("by_runs", "by_features", "found"), [(20.0, 1.0, 1), (20.0, -1.0, 0), (3.0, 40.0, 1), (3.0, 20.0, 0)]
)
def test_whole_runs_or_features_show_a_pair_and_both_speak_for_it(monkeypatch, tmp_path, by_runs, by_features, found):
    scenario = pump_scenario(tmp_path, LINES, before_sensor=GEAR)
    (stage,) = toothed_stages(scenario.rig)
    pair = other_teeth._Candidate(stage, (17, 52), log_odds=-13.0, ahead=by_runs)
    monkeypatch.setattr(other_teeth, "_candidates", lambda *_: [pair])
    monkeypatch.setattr(other_teeth, "gain_of", lambda *_: by_features)
    seen = SimpleNamespace(places=(), run=None)
    stated = other_teeth.Reading((), SimpleNamespace(seen=[seen]), None)
    read = other_teeth.other_teeth(stated, scenario.rig, lambda *_, **__: stated)
    assert len(read.faults) == found


@pytest.mark.long
def test_the_right_pair_is_left_alone(geared):
    scenario, runs = geared
    assert not prepared(scenario, runs).setup


def test_a_mesh_line_stated_at_the_wheel_moves_with_its_teeth(geared):
    scenario, _ = geared
    (stage,) = toothed_stages(scenario.rig)
    other = with_pair(scenario.rig, stage, (16, 60))
    assert other.part("mesh").order_output == 60
    assert other.part("gearbox").ratio == pytest.approx(-3.75)


def level_density(frequency):
    return np.full(frequency.shape, 2 * 0.3**2 / 2000.0)


def spectrum_of(run, *, fixed=(), highest=2.0):
    return order_spectrum(run, fixed=np.array(fixed), expected=np.full(len(fixed), 30.0), highest=highest,
                          density=level_density)  # fmt: skip


def test_a_comb_agrees_best_where_the_lines_are():
    run = drawn_run(1, speed=steady(1200.0), orders={0.333: 0.2, 0.667: 0.2}, noise=0.3)
    orders = np.array([[0.333, 0.667], [0.340, 0.680], [0.5, 1.0]])
    here, near, far = spectrum_of(run).log_ratio(orders, np.array([30.0, 30.0]))
    assert here > 20
    assert near < 0
    assert far < 0


def test_known_lines_of_other_shafts_say_nothing_of_a_stage():
    run = drawn_run(1, speed=steady(1200.0), orders={1.0: 0.5}, noise=0.1)
    assert spectrum_of(run, fixed=(1.0,)).log_ratio(np.array([[1.0]]), np.array([30.0])) == pytest.approx(0.0, abs=1e-9)


def test_a_part_of_a_bin_separates_strong_lines():
    run = drawn_run(1, speed=steady(1200.0), orders={0.1: 0.4, 0.2: 0.4}, noise=0.3)
    orders = np.array([[0.1, 0.2], [0.1017, 0.2034]])  # one tooth in 60: 0.4 and 0.8 bins
    here, near = spectrum_of(run).log_ratio(orders, np.array([100.0, 100.0]))
    assert here - near > 10


def turned_without_encoder(factor, **lines):
    """Return a run whose estimated angle is ``factor`` times the true one."""
    run = drawn_run(1, speed=steady(1200.0), noise=0.3, **lines)
    return replace(run, has_encoder=False, angle=run.angle * factor, speed=run.speed * factor)


def test_without_an_encoder_known_lines_determine_the_speed():
    run = turned_without_encoder(1.006, orders={0.1: 0.4, 0.2: 0.4, 1.0: 0.4, 2.0: 0.4})
    orders = np.array([[0.1, 0.2], [0.1017, 0.2034], [0.0984, 0.1967]])
    here, less, more = spectrum_of(run, fixed=(1.0, 2.0)).log_ratio(orders, np.array([100.0, 100.0]))
    assert here - max(less, more) > 10


def test_without_an_encoder_lines_that_the_speed_spreads_are_not_compared():
    run = turned_without_encoder(1.0, orders={8.0: 0.4})
    assert spectrum_of(run, highest=10.0).log_ratio(np.array([[8.0]]), np.array([30.0])) == pytest.approx(0.0, abs=1e-9)


def test_no_spectrum_of_a_run_up_without_a_measured_angle():
    assert spectrum_of(replace(drawn_run(1, speed=ramp(1200.0)), has_encoder=False)) is None
