"""Side lines by the sway of a shaft against its simulation, and the spread of lines that share a place."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from tests.inference.benches import FREE, bench, recorded
from torquerig import mechanisms
from torquerig.inference.features.run_features import run_features
from torquerig.inference.measured_run import measured_runs
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run

SLOW, FAST = (
    mechanisms.TorqueRipple(name="slow", at="motor", group="mechanical", amplitudes={1: 0.8}),
    mechanisms.TorqueRipple(name="fast", at="pump", group="mechanical", amplitudes={12: 0.3}),
)


def shown(folder, *, measured: bool):
    """Return the rig with a slow and a fast line, and the features of its run with and without the measured angle."""
    scenario = bench(FREE, folder)
    rig = scenario.rig + SLOW + FAST
    made = recorded(scenario, [SLOW, FAST], runs=((800, 0),))
    if not measured:
        made = [replace(one, channels={"torque_V": one.channels["torque_V"]}) for one in made]
    places = [order(each) for each in (1.0, 11.0, 12.0, 13.0)]
    return rig, run_features(measured_runs(made, scenario.rig)[0], places)


@pytest.mark.parametrize("side", [1, 3])
def test_a_line_that_sways_has_the_side_lines_of_the_simulation(tmp_path, side):
    rig, seen = shown(tmp_path, measured=False)
    expected = expected_run(rig, seen)
    assert expected.line_power[0, side] > 1e-5  # [(N m)^2] far above the noise
    assert seen.lines.power[0, side] == pytest.approx(expected.line_power[0, side], rel=0.15)


def test_a_measured_angle_leaves_a_line_of_its_shaft_without_side_lines(tmp_path):
    rig, seen = shown(tmp_path, measured=False)
    at_motor = rig.without("fast") + replace(FAST, at="motor")
    swaying = expected_run(at_motor, seen).line_power[0, 1]
    followed = run_features(replace(seen.run, followed=np.inf), seen.places)
    assert expected_run(at_motor, followed).line_power[0, 1] < 1e-6 * swaying


def test_a_sway_beyond_the_model_changes_no_line(tmp_path):
    rig, seen = shown(tmp_path, measured=False)
    huge = rig.changed(replace(SLOW, amplitudes={1: 1e4}))
    alone = expected_run(rig.without("slow"), seen).line_power[0]
    assert expected_run(huge, seen).line_power[0, 1:] == pytest.approx(alone[1:], abs=1e-9)


def test_two_lines_of_one_place_have_the_spread_of_open_phases(tmp_path):
    one, other = 0.3, 0.2  # [N m]
    scenario = bench(FREE, tmp_path)
    seen = run_features(measured_runs(recorded(scenario, [], runs=((800, 0),)), scenario.rig)[0], [order(12.0)])
    parts = [replace(FAST, name=name, amplitudes={12: size}) for name, size in (("one", one), ("other", other))]
    expected = expected_run(scenario.rig + parts[0] + parts[1], seen)
    alone = expected_run(scenario.rig + parts[0], seen)
    phase = 2 * pi * np.arange(256) / 256
    power = np.abs(one + other * np.exp(1j * phase)) ** 2
    assert expected.line_power[0, 0] / alone.line_power[0, 0] == pytest.approx(power.mean() / one**2)
    assert expected.line_beat[0, 0] == pytest.approx(np.log(power).var(), rel=1e-3)  # the same phase in all blocks
    assert alone.line_beat[0, 0] == pytest.approx(0.0, abs=1e-9)


def test_side_lines_of_one_order_by_two_causes_have_the_spread_of_open_phases(tmp_path):
    rig, seen = shown(tmp_path, measured=False)
    alone = expected_run(rig, seen)
    both = expected_run(rig + replace(SLOW, name="as slow", amplitudes={1: 0.8}), seen)
    assert alone.line_beat[0, 1] == pytest.approx(0.0, abs=1e-9)
    phase = 2 * pi * np.arange(4096) / 4096
    wanted = np.log(np.abs(1 + 0.999 * np.exp(1j * phase))).var() * 4
    assert both.line_beat[0, 1] == pytest.approx(wanted, rel=0.1)
    assert both.line_power[0, 1] == pytest.approx(2 * alone.line_power[0, 1], rel=0.1)


def test_side_lines_do_not_beat_with_their_line(tmp_path):
    rig, seen = shown(tmp_path, measured=False)
    alone = run_features(seen.run, [order(12.0)])
    table = alone.segments[0]
    wide = replace(
        table, line_half_width=np.full(1, 20.0)
    )  # [Hz] as in a short block: orders 11 and 13 are in the place
    expected = expected_run(rig, replace(alone, segments=(wide,)))
    assert expected.line_beat[0, 0] < 1e-6
