"""Lines by least squares: recovered within the chance that theory gives, and no better."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.inference.features.regression import HANN_NOISE, regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import frequency

SAMPLES, TRIALS = 1000, 400
TIME = np.arange(SAMPLES) / SAMPLES
PLACES = [frequency(30.25), frequency(71.6)]
WAVES = Waves(PLACES, TIME, TIME)
TRUE = np.array([0.3 * np.exp(0.7j), 0.05 * np.exp(-2j)])


def signal(*, level: float = 1.5, slope: float = 0.2) -> np.ndarray:
    return (
        np.real(TRUE @ np.exp(2j * pi * np.array([[30.25], [71.6]]) * TIME))
        + level
        + slope * np.linspace(-1, 1, SAMPLES)
    )


def test_lines_level_and_slope_come_back_exactly_without_noise() -> None:
    found = regressed(signal(), WAVES)
    # 1e-6: the ridge of 1e-9 pulls the strongest by so much
    assert found.amplitude == pytest.approx(TRUE, abs=1e-6)
    assert (found.level, found.slope) == pytest.approx((1.5, 0.2), abs=1e-6)
    assert np.abs(found.rest).max() < 1e-6


@pytest.mark.parametrize(("window", "factor"), [(None, 1.0), (np.hanning(SAMPLES), HANN_NOISE)])
def test_scatter_of_an_amplitude_is_twice_the_noise_over_the_samples(window: np.ndarray | None, factor: float) -> None:
    """Var Re A = 2 sigma^2 / N (Cramer-Rao of a line of known frequency), times 3/2 under a Hann window."""
    rng, sigma = np.random.default_rng(5), 0.1
    clean = signal()
    errors = np.array([
        regressed(clean + sigma * rng.standard_normal(SAMPLES), WAVES, window=window).amplitude - TRUE
        for _ in range(TRIALS)
    ])  # fmt: skip
    parts = np.concatenate([errors.real.ravel(), errors.imag.ravel()])
    expected = factor * 2 * sigma**2 / SAMPLES
    # a variance of n values scatters by sqrt(2 / n), a mean by 1 / sqrt(n); four times each
    assert parts.var() == pytest.approx(expected, rel=4 * np.sqrt(2 / parts.size))
    assert abs(parts.mean()) < 4 * np.sqrt(expected / parts.size)


def test_the_factor_of_a_hann_window_is_its_equivalent_noise_bandwidth() -> None:
    window = np.hanning(100_001)
    assert window.size * (window**2).sum() / window.sum() ** 2 == pytest.approx(HANN_NOISE, rel=1e-4)


def test_a_window_keeps_strong_slow_motion_out_of_a_weak_fast_line() -> None:
    slow = np.cos(2 * pi * 1.37 * TIME)
    bare = regressed(signal() + slow, WAVES).amplitude - TRUE
    under_hann = regressed(signal() + slow, WAVES, window=np.hanning(SAMPLES)).amplitude - TRUE
    assert np.all(np.abs(under_hann) < 0.1 * np.abs(bare))


def test_no_lines_leave_a_straight_line() -> None:
    found = regressed(signal(), Waves([], TIME, TIME))
    assert found.amplitude.size == 0
    straight = np.polyfit(np.linspace(-1, 1, SAMPLES), signal(), 1)
    assert (found.slope, found.level) == pytest.approx(tuple(straight), rel=1e-6)


def test_two_lines_at_one_place_share_it_instead_of_blowing_up() -> None:
    twice = regressed(signal(), Waves([PLACES[0], *PLACES], TIME, TIME))
    assert twice.amplitude[:2].sum() == pytest.approx(TRUE[0], abs=1e-5)
    assert np.abs(twice.amplitude[:2]).max() < abs(TRUE[0])
