"""The scatter of accelerations that come from the pulses of a tacho, against drawn pulses."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.features.level_motion import level_motion
from torquerig.inference.features.run_features import run_features
from torquerig.inference.motor_angle.smoothed_speed import speed_of
from torquerig.inference.prediction.acceleration_error import acceleration_covariance

PULSES, RATE = 24.0, 2000.0


def from_pulses(run, rng):
    """Return the run with its angle from edges that are known to a sample; their errors are independent."""
    samples = np.arange(run.angle.size)
    marks = np.arange(rng.uniform(), PULSES * run.angle[-1] / (2 * pi))
    edges = np.interp(marks * 2 * pi / PULSES, run.angle, samples) + rng.uniform(-0.5, 0.5, marks.size)
    angle = np.interp(samples, edges, marks * 2 * pi / PULSES)
    return replace(run, angle=angle, speed=speed_of(angle, RATE, window=run.window), pulses=PULSES)


@pytest.fixture(scope="module")
def scatter():
    run = drawn_run(1, speed=ramp(1500, rate=RATE), rate=RATE)
    seen = run_features(replace(run, pulses=PULSES), [])
    fast = np.abs(seen.level_speed).mean(axis=1) > 50  # rad/s; a part then has ten pulses or more
    rng = np.random.default_rng(1)
    drawn = [level_motion(from_pulses(run, rng), seen.parts)[1].mean(axis=1)[fast] for _ in range(60)]
    return np.cov(np.array(drawn).T), acceleration_covariance(seen)[np.ix_(fast, fast)]


def test_the_scatter_of_an_acceleration_is_that_of_rounded_edges(scatter):
    drawn, expected = scatter
    ratio = np.diag(drawn) / np.diag(expected)
    assert ratio.size > 20
    assert np.exp(np.mean(np.log(ratio))) == pytest.approx(1.0, rel=0.3)


def test_what_neighbours_share_is_expected(scatter):
    drawn, expected = (np.diag(each, 1) / np.sqrt(np.diag(each)[1:] * np.diag(each)[:-1]) for each in scatter)
    assert np.ptp(expected) > 0.3
    assert np.corrcoef(drawn, expected)[0, 1] > 0.5


def test_a_measured_angle_or_a_steady_speed_has_no_such_error():
    assert acceleration_covariance(run_features(drawn_run(1, speed=ramp(1500)), [])) is None
    still = replace(drawn_run(1, speed=steady(1500)), pulses=PULSES)
    assert acceleration_covariance(run_features(still, [])) is None
