"""What a model lacks stays visible: it is not taken for an error that any right model has."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference.additions.bearing_defect import refined
from torquerig.inference.discrepancy import MEDIAN, SPREAD, estimated
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, sketched
from torquerig.inference.model import lacks
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import expected_run

PLACES = [order(each) for each in (7.0, 9.0, 11.0, 13.0)]


@pytest.fixture
def rig(tmp_path):
    return pump_scenario(tmp_path).rig


def test_strong_lines_that_a_model_lacks_leave_its_sizes_usual(rig):
    run = drawn_run(1, speed=steady(1000), orders={place.at: 2.0 for place in PLACES}, noise=0.05)
    seen = run_features(run, PLACES)
    off = estimated([seen], [expected_run(rig, seen)], MEDIAN)
    for size in ("line", "band", "mode", "modulation"):
        assert getattr(off, size) <= getattr(MEDIAN, size) * np.exp(2 * SPREAD) * (1 + 1e-9)


@pytest.mark.parametrize(("size", "is_lacking"), [(1.0, False), (0.7, False), (0.1, True)])
def test_a_line_that_a_model_makes_is_not_lacking(rig, size, is_lacking):
    place = order(9.0)
    unit = mechanisms.TorqueRipple(name="x", at="motor", group="mechanical", amplitudes={9.0: 1.0})
    empty = run_features(drawn_run(2, speed=steady(1000)), [place])
    gain = float(np.sqrt(expected_run(rig + unit, empty).line_power[0, 0]))
    run = drawn_run(2, speed=steady(1000), orders={9.0: 0.5}, noise=0.01)
    made = mechanisms.TorqueRipple(name="x", at="motor", group="mechanical", amplitudes={9.0: size * 0.5 / gain})
    data = Data.of([run_features(run, [place])])
    fit = sketched(rig + made, (), data, iterations=0)
    assert lacks(fit, data, place) == is_lacking


def test_the_order_of_impacts_is_that_of_their_comb():
    assert refined(7.187, [7.1919, 14.384, 35.947]) == pytest.approx(7.1919, abs=2e-3)
    assert refined(3.1, []) == 3.1
