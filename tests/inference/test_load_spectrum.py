"""What the gains of a load's spectrum take for the load, in nats of their prior, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.features.run_features import run_features
from torquerig.inference.load_spectrum import COURSE_SD, gain_shapes
from torquerig.inference.prediction.hit_courses import hit_courses
from torquerig.mechanisms.particle_load import ParticleProcess
from torquerig.rig.terms import Load

ERROR = 0.1  # [1] of the logarithm of a band's density


@pytest.fixture(scope="module")
def spectrum():
    run = drawn_run(1, speed=steady(1000))
    seen = run_features(run, [])
    return seen.bands.middle, gain_shapes(seen, run=0, runs=[run]).bands[0]


def nats(shape, change):
    """Return minus the largest log posterior of gains that explain a change of the logarithm of the density."""
    scaled = shape / ERROR
    gains = np.linalg.solve(scaled.T @ scaled + np.eye(shape.shape[1]), scaled.T @ (change / ERROR))
    return 0.5 * float(np.square((change - shape @ gains) / ERROR).sum() + np.square(gains).sum())


@pytest.mark.parametrize("corner", [5.0, 23.0, 117.0])
def test_a_load_that_ends_at_any_frequency_costs_less_than_a_finding_needs(spectrum, corner):
    at, shape = spectrum
    assert nats(shape, -np.log1p((at / corner) ** 4)) < 8.0


@pytest.mark.parametrize("slope", [-0.7, 0.7])
def test_a_load_of_another_slope_above_its_corner_is_usual(spectrum, slope):
    at, shape = spectrum
    assert nats(shape, slope * np.log(np.maximum(at / 5.0, 1.0))) < 3.0


def test_a_narrow_peak_is_no_load(spectrum):
    at, shape = spectrum
    peak = 2.0 * (np.arange(at.size) == at.size // 2)
    assert nats(shape, peak) > 0.8 * nats(np.zeros_like(shape), peak)


def test_the_course_of_hits_is_a_parameter():
    process = ParticleProcess(mean=2.0, rate=50.0, decay=0.005, shape=1.5, hit_rms=0.1, slow_rms=0.0, slow_cutoff=1.0)
    run = drawn_run(1, speed=steady(1000))
    seen = run_features(run, [])
    shape, bands = gain_shapes(seen, run=0, runs=[run]), seen.bands
    load = Load(name="load", on="motor", process=process)
    changes = hit_courses([load], bands)
    gains = shape.courses[0] / COURSE_SD  # half a sine
    zero = 1.5 / (0.5 * np.pi * process.decay)
    inside = (bands.low < zero) & (bands.high > zero)
    assert (shape.courses @ gains) @ changes == pytest.approx(changes[0])
    assert changes[0, inside] < changes[0, bands.middle < 0.5 * zero].min() - 2.0
    assert changes[:, 0] == pytest.approx(np.log([2 / np.pi, 0.75]), abs=0.02)  # energies of the pulses
