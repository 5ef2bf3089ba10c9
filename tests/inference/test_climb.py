"""Derivatives of a fit are made anew only where they are wrong, and the maximum is the same."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig.inference import climb
from torquerig.inference.climb import Case, Point
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, finished, fitted, sketched
from torquerig.inference.knobs import with_free_load
from torquerig.inference.likelihood import Discrepancy
from torquerig.inference.parameters import parameters
from torquerig.inference.places import order


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    scenario = pump_scenario(tmp_path_factory.mktemp("pump"))
    rig = with_free_load(scenario.rig)
    runs = [drawn_run(1, speed=steady(1000), orders={1.0: 0.3})]
    return rig, parameters(scenario, rig, runs), Data.of([run_features(run, [order(1.0)]) for run in runs])


@pytest.fixture(scope="module")
def fit(case):
    return fitted(*case)


def test_derivatives_at_other_sizes_need_no_evaluation(case):
    rig, knobs, data = case
    at, other = Case(rig, knobs, data, Discrepancy()), Discrepancy(line=0.1)
    start = Point(np.zeros(len(knobs)), np.zeros(data.shapes[0].count), at.expected(np.zeros(len(knobs))))
    before = climb.slopes_at(at, start)
    made = climb.slopes_at(replace(at, off=other), start)
    assert not np.allclose(before, made, rtol=0.01, atol=1e-9)
    after, count = climb.resized(at, replace(start, slopes=before), other).slopes, len(made) // 2
    assert after[:count] == pytest.approx(made[:count], rel=1e-9, abs=1e-9)


def test_wrong_derivatives_lead_to_the_same_maximum(case, fit):
    wrong = fit.jacobian * np.linspace(-0.5, 1.5, fit.jacobian.shape[1])
    rough = sketched(*case, start=fit.positions + 0.05, gains=fit.gains, off=fit.off, jacobian=wrong)
    assert not rough.is_finished
    again = finished(rough, case[2])
    assert again.log_posterior > fit.log_posterior - 1.0  # no model explains these runs well: other maxima are near
    assert again.log_posterior > rough.log_posterior - 1e-6


def test_a_fit_ends_where_no_single_number_makes_the_posterior_larger(case, fit):
    rig, knobs, data = case
    at = Case(rig, knobs, data, fit.off)
    place = np.concatenate([fit.positions, fit.gains])
    curvature = np.diag(np.linalg.inv(fit.covariance()))

    def score(position):
        expected = at.expected(position[: len(knobs)])
        numbers, gains = position[: len(knobs)], position[len(knobs) :]
        return climb._score(*climb._flat(data, expected, gains, fit.off), numbers, gains)

    steps = 0.02 * np.eye(place.size)
    slopes = np.array([(score(place + step) - score(place - step)) / 0.04 for step in steps])
    assert np.max(0.5 * slopes**2 / curvature) < 0.2  # [nats] that one number alone would still gain


def test_a_step_blames_the_derivatives_that_it_follows_from():
    slopes, value = np.concatenate([np.diag([1.0, 1.0, 1.0, 0.01]), np.zeros((4, 4))]), np.zeros(4)
    step = np.array([1.0, 4.0, 0.1, 5.0])

    def at_fault(step, *fresh):
        return np.flatnonzero(climb._at_fault(slopes, value, step, np.isin(np.arange(4), fresh), rest=0.1)).tolist()

    assert at_fault(step) == [1]
    assert at_fault(step, 1) == []  # it was too long
    assert at_fault(step[[1, 0, 2, 3]], 1) == [0]


def test_a_parameter_that_moved_far_leaves_derivatives_behind(fit):
    at = Point(fit.positions, fit.gains, fit.expected, made=np.concatenate([fit.positions, fit.gains]))
    assert climb.is_made_near(at, fit.knobs)
    wide = int(np.argmax([knob.spread if knob.factor else 0.0 for knob in fit.knobs]))
    moved = fit.positions.copy()
    moved[wide] += 0.2 / fit.knobs[wide].spread
    assert not climb.is_made_near(replace(at, positions=moved), fit.knobs)
    assert not climb.is_made_near(replace(at, made=None), fit.knobs)
