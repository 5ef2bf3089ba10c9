"""Covariance of levels and of powers against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.features.run_features import run_features
from torquerig.inference.likelihood import (
    _of_logarithm,
    _with_common_factor,
)
from torquerig.inference.prediction.rig_lines import beat_variance
from torquerig.inference.prediction.slow_lines import UnshownLines, covariance_of_lines
from torquerig.inference.prediction.slow_torque import covariance
from torquerig.mechanisms.particle_load import ParticleProcess


def test_white_noise_leaves_half_its_density_over_the_length_in_each_mean():
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    found = covariance(seen, np.full(seen.level_grid.size, 0.3))
    # the grid ends where 2.5 % of the integral of sinc^2 is left
    assert np.diag(found) == pytest.approx(0.3 / (2 * seen.level_duration), rel=0.03)
    assert np.abs(found - np.diag(np.diag(found))).max() < 0.03 * found[0, 0]


def test_a_slow_line_moves_neighbouring_means_together():
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    found = covariance_of_lines(seen, UnshownLines(np.array([0.01]), np.array([[0.5]]), follows=False))
    assert found[0, 1] == pytest.approx(0.5, rel=0.01)


@pytest.mark.parametrize("course", [ramp(600), steady(60), np.concatenate([ramp(600), -ramp(600)[::-1]])])
def test_a_slow_order_has_one_phase_in_all_mean_torques(course):
    drawn = [drawn_run(seed, speed=course, orders={0.2: 0.1}, noise=0.0) for seed in range(60)]
    seen = run_features(drawn[0], [])
    square = np.full((1, len(seen.segments)), 0.5 * 0.1**2)
    expected = covariance_of_lines(seen, UnshownLines(np.array([0.2]), square, follows=True))
    levels = np.array([run_features(run, []).level for run in drawn]) - 1.0
    # the phase is drawn anew in each run: 60 of them scatter the covariance by some 0.5 / sqrt(60) of its largest value
    assert np.abs(levels.T @ levels / 60 - expected).max() < 0.25 * expected.max()


def test_means_of_a_block_that_shows_a_line_are_without_it():
    seen = run_features(drawn_run(1, speed=steady(1000), orders={1.0: 0.3}), [])
    none = UnshownLines(np.array([1.0]), np.zeros((1, 1)), follows=True)
    assert not covariance_of_lines(seen, none).any()


@pytest.mark.parametrize("ratio", [0.02, 0.3, 0.9])
def test_two_lines_in_one_place_beat(ratio):
    phase = np.random.default_rng(2).uniform(0, 2 * np.pi, 200_000)
    power = np.abs(1 + np.sqrt(ratio) * np.exp(1j * phase)) ** 2
    found = beat_variance(np.array([[1 + ratio]]), np.array([[1.0]]), np.array([[1.0]]))
    assert found[0, 0] == pytest.approx(np.log(power).var(), rel=0.02)


@pytest.mark.parametrize("count", [1.0, 3.0, 40.0])
def test_the_logarithm_of_a_mean_of_few_powers(count):
    powers = np.random.default_rng(3).gamma(count, 1 / count, 200_000)
    variance, lower = _of_logarithm(np.array([count]))
    assert np.log(powers).var() == pytest.approx(variance[0], rel=0.03)
    assert np.log(powers).mean() == pytest.approx(-lower[0], abs=0.01)


@pytest.mark.parametrize(("rate", "shape"), [(20.0, 1.5), (60.0, 4.0)])
def test_few_hits_scatter_the_power_of_all_bands_together(rate, shape):
    process = ParticleProcess(
        mean=1.0, rate=rate, decay=1e-3, shape=shape, hit_rms=1e-3, slow_rms=0.0, slow_cutoff=1.0
    )  # fmt: skip
    rng, duration = np.random.default_rng(4), 4.0
    spectra = np.array([np.abs(np.fft.rfft(process.sample(4000, 1000.0, rng) - 1.0)[8:1600]) ** 2 for _ in range(500)])
    low, high = (np.log(half.mean(axis=1)) for half in np.array_split(spectra, 2, axis=1))
    assert np.cov(low, high)[0, 1] == pytest.approx(process.clumping / duration, rel=0.3)


def test_residuals_with_a_common_factor_become_independent():
    rng, shown = np.random.default_rng(5), np.ones((2, 30), dtype=bool)
    common, sd = np.full(shown.shape, 0.4), rng.uniform(0.1, 0.5, shown.size)
    made = [_with_common_factor(
        sd * rng.standard_normal(shown.size) + 0.4 * np.repeat(rng.standard_normal(2), 30), sd, common, shown
    ) for _ in range(2000)]  # fmt: skip
    z = np.array([value / wider for value, wider in made])
    assert np.cov(z.T) == pytest.approx(np.eye(shown.size), abs=0.12)
    # the determinant of the covariance of a segment is in the standard deviations
    square = np.square(0.4 / sd[:30]).sum()
    assert np.log(made[0][1][:30] / sd[:30]).sum() == pytest.approx(0.5 * np.log1p(square))


@pytest.mark.parametrize("follows", [True, False], ids=["orders", "tones"])
def test_lines_leave_together_what_each_leaves_alone(follows):
    seen = run_features(drawn_run(1, speed=ramp(1000)), [])
    at = np.array([0.1, 0.3, 0.1, 500.0])  # two of one order, and one that no mean shows
    square = np.random.default_rng(2).uniform(0.1, 1.0, (at.size, len(seen.segments)))
    square[0, 0] = 0.0
    each = [covariance_of_lines(seen, UnshownLines(at[[row]], square[[row]], follows)) for row in range(at.size)]
    found = covariance_of_lines(seen, UnshownLines(at, square, follows))
    assert np.abs(found).max() > 0.01
    assert found == pytest.approx(np.sum(each, axis=0), rel=1e-12, abs=1e-15)
