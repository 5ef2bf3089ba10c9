"""What is kept of a recording between two models changes neither of them."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference.features.run_features import run_features
from torquerig.inference.kept import MOST, Kept
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_line_power, expected_run
from torquerig.inference.prediction.line_features import line_features
from torquerig.linear_twin.twin import Twin

CHANGES = (
    ("lines", {"amplitudes": {1.0: 0.5, 3.2: 0.1}}), ("load", {"hit_rms": 0.6}), ("pump", {"inertia": 0.04}),
    ("sensor", {"bandwidth": 60.0}), ("sensor", {"noise_rms": 0.02}), ("lines", {"phases": {1.0: 0.5}}),
    ("load", {"mean_by_occupancy_percent": {0: 3.0, 100: 3.0}}),
)  # fmt: skip


@pytest.mark.parametrize("speed", [steady(1000), ramp(1200)], ids=["steady", "ramp"])
@pytest.mark.parametrize("followed", [np.inf, 0.0], ids=["encoder", "no angle"])
def test_a_model_expects_the_same_after_others(speed, followed, tmp_path):
    run = replace(drawn_run(1, speed=speed, orders={1.0: 0.3}), followed=followed)
    seen, rig = run_features(run, [order(1.0)]), pump_scenario(tmp_path).rig
    rigs = [rig, *(rig.changed(replace(rig.part(name), **changed)) for name, changed in CHANGES), rig]
    for one in rigs:
        after, alone = expected_run(one, seen), expected_run(one, replace(seen))
        for each in fields(alone):
            assert np.array_equal(getattr(after, each.name), getattr(alone, each.name)), each.name


def test_the_power_of_the_lines_is_that_of_all_that_is_expected(tmp_path):
    seen = run_features(drawn_run(1, speed=ramp(1200), orders={1.0: 0.3}), [order(1.0)])
    rig = pump_scenario(tmp_path).rig
    course = mechanisms.ReadingCourse(name="course", shape="step", at=0.4, gain=0.3)
    for one in (rig, rig + course):
        assert np.array_equal(expected_line_power(one, replace(seen)), expected_run(one, seen).line_power)


def test_what_a_change_cannot_reach_is_not_evaluated_again(tmp_path):
    run = drawn_run(1, speed=steady(1000), orders={1.0: 0.3})
    seen, rig = run_features(run, [order(1.0)]), pump_scenario(tmp_path).rig
    noisier = rig.changed(replace(rig.part("sensor"), noise_rms=0.02))
    emptier = rig.changed(replace(rig.part("load"), mean_by_occupancy_percent={0: 2.0, 100: 3.0}))
    assert line_features(Twin(noisier.at(run.run)), seen) is line_features(Twin(rig.at(run.run)), seen)
    assert expected_run(noisier, seen) is not expected_run(rig, seen)
    assert expected_run(emptier, seen) is expected_run(rig, seen)


def test_answers_are_made_once_and_the_oldest_goes():
    kept, made = Kept(), []
    for key in [*range(MOST), 0, MOST, 1, 0]:
        assert kept.get("squares", key, lambda key=key: made.append(key) or key**2) == key**2
    assert made == [*range(MOST), MOST, 1]
