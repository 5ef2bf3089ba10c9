"""Courses of zero and gain of a reading: what they make of the features, and that they are found."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario, recorded
from torquerig import mechanisms
from torquerig.inference.answer import as_json
from torquerig.inference.engine import diagnose
from torquerig.inference.features.run_features import run_features
from torquerig.inference.prediction.reading_courses import course_density, courses, slow_noise
from torquerig.sensor_stages.band_noise import BandNoise
from torquerig.sensor_stages.course import Course

SHAPES = [("step", 0.43), ("ramp", 0.43), ("settling", 0.2)]


class Rig:
    """A rig of which only its stages are known."""

    def __init__(self, *stages):
        self._stages = stages

    def stages(self):
        return self._stages


def seen_with(course):
    """Return the features of a quiet run at 2 N m with a course on its reading, and of it without."""
    run = drawn_run(1, speed=steady(1000), noise=1e-4, level=2.0)
    share = np.arange(run.torque.size) / run.torque.size
    moved = course.course(share)
    return (
        run_features(replace(run, torque=run.torque * (1 + course.gain * moved) + course.zero * moved), []),
        run_features(run, []),
    )


@pytest.mark.parametrize(("shape", "at"), SHAPES)
@pytest.mark.parametrize("sizes", [{"zero": 0.3}, {"gain": 0.2}])
def test_mean_torques_follow_a_course(shape, at, sizes):
    course = Course(shape=shape, at=at, **sizes)
    seen, plain = seen_with(course)
    found = courses(Rig(course), seen)
    # the noise of a mean of 1000 samples is 3e-6 N m; sums and integrals differ by one sample in 1000
    assert found.gain * plain.level + found.zero == pytest.approx(seen.level, abs=5e-4)


def test_a_step_within_a_block_is_in_its_bands():
    course = Course(shape="step", at=0.43, zero=0.3)
    seen, plain = seen_with(course)
    expected = course_density(Rig(course), seen, plain.level)[0]
    low = seen.bands.middle < 100.0  # above, the noise is the larger part
    shown = low & np.isfinite(seen.band_power[0])
    assert seen.band_power[0][shown] == pytest.approx(expected[shown] + plain.band_power[0][shown], rel=0.05)


@pytest.mark.parametrize("frequency", [0.2, 1.0])
def test_slow_noise_moves_the_mean_torques(frequency):
    noise, run, rng = (
        BandNoise(rms=0.3, frequency=frequency, width=0.7),
        drawn_run(1, speed=steady(1000)),
        np.random.default_rng(8),
    )
    bins = np.fft.rfftfreq(run.torque.size, 1 / run.rate)
    shape = np.sqrt(noise.density(bins, run.rate) * run.rate / 2)
    drawn = [np.fft.irfft(np.fft.rfft(rng.standard_normal(run.torque.size)) * shape) for _ in range(60)]
    levels = np.array([run_features(replace(run, torque=each), []).level for each in drawn])
    expected = slow_noise(Rig(noise), run_features(run, []))
    # 60 draws scatter a variance by 18 %, its mean over the correlated parts by some 8 %
    assert np.mean(levels**2) == pytest.approx(np.diag(expected).mean(), rel=0.3)


@pytest.mark.parametrize(("shape", "at"), SHAPES)
def test_the_mean_of_a_course_is_that_of_its_values(shape, at):
    course, edges = Course(shape=shape, at=at), np.array([0.0, 0.2, 0.4, 0.45, 1.0])
    for low, high in pairwise(edges):
        values = course.course(np.linspace(low, high, 20_001))
        assert course.mean(low, high) == pytest.approx(np.trapezoid(values) / 20_000, abs=1e-4)


@pytest.mark.long
@pytest.mark.parametrize("zero", [0.2, -0.3])
def test_a_zero_that_jumps_is_located_without_a_name(tmp_path, zero):
    scenario = pump_scenario(tmp_path)
    jump = mechanisms.ReadingCourse(name="jump", shape="step", at=0.45, zero=zero)
    data = as_json(diagnose(scenario, recorded(scenario, jump)))
    assert data["verdict"] == "unexplained"
    assert not data["findings"]
    (course,) = data["unnamed"]
    assert course["axis"] == "s"
    assert course["kind"] in ("level_course", "gain_course")  # at one load a gain and a zero are alike
    assert course["at"] == pytest.approx(0.45 * 6.0, abs=0.25)  # a part of a block, whose mean is all that is compared
    before, after = (data["fit"][key]["heldout_misfit"] for key in ("before", "after"))
    assert before - after > 0.7 * (before - 1)
