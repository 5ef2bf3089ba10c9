"""What coarse codes add: white at first, with the colour of the signal once it moves less than a code a sample."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.signal import butter, lfilter, welch

from torquerig.diagnosis.expecting.rounding_noise import rounded_lines, rounding_density, rounding_tolerance

RATE, STEP = 5000.0, 0.2
FREQUENCY = np.geomspace(1.0, 2400.0, 90)
NONE = np.zeros(0)


def test_rounding_fast_noise_is_white_and_has_a_twelfth_of_the_step_squared() -> None:
    white = np.full(FREQUENCY.size, 2 * 0.3**2 / RATE)
    added = rounding_density(0.1, rate=RATE, frequency=FREQUENCY, power=white, lines=NONE, sizes=NONE)
    assert added == pytest.approx(0.1**2 / 12 * 2 / RATE, rel=1e-3)


@pytest.mark.parametrize("step", [0.05, 0.2, 0.5])
def test_rounding_a_slow_signal_has_the_spectrum_of_its_error(step: float) -> None:
    """Against the error itself, 60 s of a process through a 40 Hz low-pass with a line on it."""
    rng, count = np.random.default_rng(3), int(60 * RATE)
    b, a = butter(2, 40.0, fs=RATE)
    time = np.arange(count) / RATE
    process = lfilter(b, a, 5.0 * rng.standard_normal(count))
    values = process + 0.3 * np.cos(2 * np.pi * 7.3 * time)
    found, density = welch(step * np.round(values / step) - values, RATE, nperseg=4096)
    known, power = welch(process, RATE, nperseg=4096)
    added = rounding_density(
        step, rate=RATE, frequency=known[1:], power=power[1:], lines=np.array([7.3]), sizes=np.array([0.3])
    )
    edges = np.geomspace(5.0, 2400.0, 12)
    for low, high in pairwise(edges):
        inside = (found[1:] > low) & (found[1:] < high)
        # 145 averages; few bins in the lowest bands: 5 % of chance there, and where the tail is steep
        assert added[inside].mean() == pytest.approx(density[1:][inside].mean(), rel=0.2), (low, high)


def test_the_fewer_codes_a_signal_spans_the_less_is_promised() -> None:
    power = np.ones(3)
    small, large = (rounding_tolerance(step, 0.5 * power, power, spread=0.1) for step in (0.01, 0.3))
    assert np.all(small < 0.02)
    assert np.all(large > 0.15)


@pytest.mark.parametrize("dither", [0.02, 0.15, 0.3])
def test_lines_that_rounding_makes_are_as_large_as_it_may_make_them(dither: float) -> None:
    rng = np.random.default_rng(7)
    time = np.arange(60_000) / 5000.0
    window = np.hanning(time.size)
    largest = []
    for _ in range(12):
        lines = zip(rng.uniform(0.05, 1.0, 4), rng.uniform(5.0, 300.0, 4), rng.uniform(0.0, 6.3, 4), strict=True)
        signal = sum(size * np.cos(2 * np.pi * at * time + phase) for size, at, phase in lines)
        signal = signal + rng.uniform() + dither * rng.standard_normal(time.size)
        error = STEP * (np.round(signal) - signal)
        largest.append(2 * np.abs(np.fft.rfft(error * window)).max() / window.sum())
    # chance itself makes lines of a hundredth of a code
    assert np.median(largest) == pytest.approx(
        np.hypot(rounded_lines(STEP, dither=dither * STEP), 0.01 * STEP), rel=0.5
    )
    assert np.max(largest) < 3 * np.hypot(rounded_lines(STEP, dither=dither * STEP), 0.01 * STEP)
