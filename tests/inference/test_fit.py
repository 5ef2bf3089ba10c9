"""A fit gives the same numbers however its derivatives are computed."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.benches import GEARED, bench
from tests.inference.drawn_runs import drawn_run, ramp, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference.answer.numbers import estimate
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, sketched
from torquerig.inference.knobs import Knob, declared, turned, with_free_load, within
from torquerig.inference.parameters import parameters
from torquerig.inference.places import order
from torquerig.parallel import parallel_processes
from torquerig.rig.parts import WormGear


@pytest.fixture
def case(tmp_path):
    scenario = pump_scenario(tmp_path)
    rig = with_free_load(scenario.rig)
    runs = [drawn_run(1, speed=steady(1000), orders={1.0: 0.3}), drawn_run(2, speed=ramp(1200), orders={1.0: 0.3})]
    return rig, parameters(scenario, rig, runs), Data.of([run_features(run, [order(1.0)]) for run in runs])


def test_two_processes_find_the_numbers_of_one(case):
    alone = sketched(*case, iterations=2)
    with parallel_processes(2):
        shared = sketched(*case, iterations=2)
    assert len(alone.knobs) >= 12  # fewer are not worth a second process
    assert shared.log_evidence == alone.log_evidence
    assert np.array_equal(shared.positions, alone.positions)
    assert np.array_equal(shared.jacobian, alone.jacobian)


def test_kept_answers_do_not_change_a_fit(case):
    first = sketched(*case, iterations=2)
    again = sketched(*case, iterations=2)
    assert again.log_evidence == first.log_evidence
    assert np.array_equal(again.jacobian, first.jacobian)


def test_no_number_goes_beyond_what_its_part_allows(tmp_path):
    rig = bench(GEARED, tmp_path).rig
    knob = Knob("gearbox", "efficiency", 0.01)  # 0.97 is stated, and no gear gives out more than it takes
    beyond = np.array([9.0])
    assert turned(rig, (knob,), beyond).part("gearbox").efficiency == 1.0
    fit = SimpleNamespace(rig=rig, knobs=(knob,), positions=beyond, covariance=lambda: np.eye(1))
    assert estimate(fit, 0, "1") == {"value": 1.0, "ci95": [1.0, 1.0], "unit": "1"}


RIPPLE = mechanisms.TorqueRipple(name="x", at="pump", group="mechanical", amplitudes={2.0: 0.1})
IMPACTS = mechanisms.BearingDefect(name="x", order_output=3.6, ring_frequency=300.0, amplitude=0.1)
WORM = WormGear(
    name="x", starts=1, wheel_teeth=40, lead_angle=0.1, forward_efficiency=0.7, stiffness=1e3, damping=1.0
)  # fmt: skip


@pytest.mark.parametrize(
    ("part", "field", "value", "allowed", "unit"),
    [
        (RIPPLE, "amplitudes", 7.0, 7.0, "N*m"),
        (WORM, "forward_efficiency", 1.2, 1.0, "1"),
        (IMPACTS, "slip", -0.1, 0.0, "1"),
    ],
)
def test_bounds_and_unit_are_those_of_the_declaration(part, field, value, allowed, unit):
    assert within(part, field, value) == allowed
    assert declared(part, field).unit == unit
