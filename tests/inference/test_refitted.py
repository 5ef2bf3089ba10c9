"""A model with fewer parameters is fitted as if the others had never been free."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig import mechanisms
from torquerig.inference import climb
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, fitted, sketched
from torquerig.inference.knobs import Knob, with_free_load
from torquerig.inference.parameters import parameters
from torquerig.inference.places import order
from torquerig.inference.refitted import refitted


@pytest.fixture
def case(tmp_path):
    scenario = pump_scenario(tmp_path)
    rig = with_free_load(scenario.rig)
    runs = [drawn_run(1, speed=steady(1000), orders={1.0: 0.3}), drawn_run(2, speed=steady(700), orders={1.0: 0.3})]
    return rig, parameters(scenario, rig, runs), Data.of([run_features(run, [order(1.0)]) for run in runs])


@pytest.mark.parametrize("name", ["sensor.zero", "pump.inertia"])
def test_a_number_held_at_its_stated_value_moves_the_others_there(case, name):
    rig, knobs, data = case
    assert name in {knob.name for knob in knobs}
    held = refitted(fitted(rig, knobs, data), data, keeps=lambda knob: knob.name != name)
    alone = fitted(rig, tuple(knob for knob in knobs if knob.name != name), data)
    # no model explains these runs well, so that two starts end up to 1 nat apart; a wrong start ends 36 nats lower
    assert held.log_posterior > alone.log_posterior - 1.5
    part, field = name.split(".")
    assert getattr(held.fitted_rig.part(part), field) == getattr(rig.part(part), field)


def test_a_part_that_is_left_out_leaves_with_its_parameters(case):
    rig, knobs, data = case
    drift = mechanisms.SensorDrift(name="drift", span=0.0, time_constant=None)
    full = fitted(rig + drift, (*knobs, Knob("drift", "span", 0.3, factor=False)), data)
    less = refitted(full, data, keeps=lambda knob: knob.part != "drift", without=frozenset({"drift"}))
    assert less.rig == rig
    assert less.knobs == tuple(knobs)


def test_a_part_that_others_need_cannot_be_left_out(case):
    rig, knobs, data = case
    full = sketched(rig, knobs, data, iterations=1)
    assert refitted(full, data, keeps=lambda knob: knob.part != "pump", without=frozenset({"pump"})) is None


def test_sketches_of_a_smaller_model_begin_with_the_derivatives_of_the_larger_one(case, monkeypatch):
    full = fitted(*case)
    made, slopes_at = list[bool](), climb.slopes_at
    monkeypatch.setattr("torquerig.inference.refitted.finished", lambda fit, _: fit)
    monkeypatch.setattr(
        climb, "slopes_at", lambda at, point, *, kept=None: made.append(kept is None) or slopes_at(at, point, kept=kept)
    )
    again = refitted(full, case[2], keeps=lambda _: True)
    assert not any(made)
    assert np.abs(again.positions - full.positions).max() < 0.3
