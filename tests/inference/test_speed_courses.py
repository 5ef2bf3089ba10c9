"""Torques that follow the speed by no law: what they make of the mean torques, and where they are found."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.errors import InputError
from torquerig.inference.additions import speed_course
from torquerig.inference.features.run_features import run_features
from torquerig.inference.fit import Data, all_residuals
from torquerig.inference.likelihood import LEVEL, Discrepancy
from torquerig.inference.prediction.expected_run import ExpectedRun, _zero
from torquerig.sensor_stages.speed_course import SpeedCourse

SHAPES = ["kink", "window"]
TOP = 1000 * np.pi / 30


class Rig:
    """A rig of which only its stages are known."""

    parts = ()

    def __init__(self, *stages):
        self._stages = stages

    def stages(self):
        return self._stages


class Known:
    """What a hypothesis is proposed from, of runs whose model is a constant torque with a free zero and scale."""

    shafts = (type("Last", (), {"part": "pump", "turns": 0.5}),)
    signal = 0.3

    def __init__(self, *seen):
        self.data, self.rig = Data.of(seen), Rig()
        off, gains = Discrepancy(), np.zeros(self.data.shapes[0].count)
        models = [model_of(each) for each in seen]
        found = all_residuals(self.data, models, gains, off)
        value = np.concatenate([np.where(each.kind == LEVEL, each.standardised, 0.0) for each in found])
        none = np.zeros((2 * value.size, 1))
        fitted = {"off": off, "expected": models, "gains": gains, "value": value, "jacobian": none}
        self.fit = type("Fitted", (), fitted)


def model_of(seen):
    """Return a model that expects 1 N m and what the bands of the run show."""
    lines, bands, levels = seen.line_frequency.shape, seen.band_power.shape, seen.level.size
    none, covariance = np.zeros(lines), 1e-4 * np.eye(levels)
    return ExpectedRun(
        line_power=none, line_slope=none, line_range=none, line_beat=none, near_lines=none, density=np.ones(bands),
        load_share=np.zeros(bands), near_bands=np.zeros(bands), level=np.ones(levels), level_covariance=covariance,
        slow_load=0 * covariance, level_rate=np.zeros(levels), level_range=np.zeros(levels),
    )  # fmt: skip


def seen_with(course, speed):
    """Return the features of a run at 1 N m with a course over the speed on its reading."""
    run = drawn_run(1, speed=speed, noise=1e-3, level=1.0)
    return run_features(replace(run, torque=run.torque + course.torque(run.speed)), [])


@pytest.mark.parametrize("shape", SHAPES)
def test_mean_torques_follow_the_speed(shape):
    course = SpeedCourse(shape=shape, at=0.5 * TOP, size=0.2)
    seen = seen_with(course, ramp(1000))
    # a part has up to 2 % of the top speed, of which 9 points are kept: an error of some 1 % of the size
    assert _zero(Rig(course), seen) == pytest.approx(seen.level - 1.0, abs=2e-3)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("size", [0.2, -0.1])
def test_the_right_shape_and_speed_explain_most(shape, size):
    course = SpeedCourse(shape=shape, at=0.5 * TOP, size=size)
    found = list(speed_course.propose(Known(seen_with(course, ramp(1000)))))
    best = next(each for each in found if each.variant == shape)
    (part,), (_, at), start = best.parts, best.knobs, best.starts[0]
    speed = at.turned(part.at, start[1])
    assert speed == pytest.approx(0.5 * TOP, rel=0.05)  # half a step of the grid
    assert np.sign(start[0]) == np.sign(size)
    assert f"{speed * 0.5 * 30 / np.pi:.4g} rpm of pump" in best.label


def test_runs_at_one_speed_show_no_course_over_the_speed():
    course = SpeedCourse(shape="window", at=0.5 * TOP, size=0.2)
    runs = [seen_with(course, steady(rpm)) for rpm in (400.0, 500.0, 700.0)]
    assert not list(speed_course.propose(Known(*runs)))


def test_a_resistance_turns_with_the_direction():
    course = SpeedCourse(shape="kink", at=10.0, size=0.2)
    assert course.torque(np.array([-20.0, -5.0, 5.0, 20.0])) == pytest.approx([-0.2, 0.0, 0.0, 0.2])


def test_a_course_at_no_speed_cannot_be():
    with pytest.raises(InputError, match="write more than 0 rad/s"):
        SpeedCourse(shape="kink", at=0.0, size=0.1)
