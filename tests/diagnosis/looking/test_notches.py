"""A notch that all steady runs have is found where it is; one of a single run, a shallow one and noise are none."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import iirnotch, lfilter

from torquerig.diagnosis.looking.notches import notches
from torquerig.diagnosis.looking.observed import Observed

RATE, SAMPLES = 1000.0, 12_000
ByHand = Callable[..., Observed]


def noise(seed: int, *, at: Sequence[float] = (), quality: float = 8.0) -> np.ndarray:
    values = np.random.default_rng(seed).standard_normal(SAMPLES)
    for hertz in at:
        values = lfilter(*iirnotch(hertz, quality, RATE), values)
    return np.asarray(values)


@pytest.fixture
def runs(by_hand: ByHand) -> Callable[..., list[Observed]]:
    def made(*torques: np.ndarray) -> list[Observed]:
        angle = np.arange(SAMPLES) / RATE * 100.0
        return [by_hand(torque, angle * (1 + 0.2 * row), rate=RATE) for row, torque in enumerate(torques)]

    return made


@pytest.mark.parametrize("at", [(30.0,), (46.3,), (25.0, 80.0)])
def test_what_all_runs_have_is_found_to_a_bin(at: tuple[float, ...], runs: Callable[..., list[Observed]]) -> None:
    found = notches(runs(*(noise(seed, at=at) for seed in (1, 2, 3))))
    assert found == pytest.approx(at, abs=0.5)  # a stretch of 2 s


def test_nothing_is_found_in_noise_or_where_one_run_lacks_it(runs: Callable[..., list[Observed]]) -> None:
    for seed in range(0, 60, 3):
        assert notches(runs(*(noise(seed + row) for row in range(3)))) == ()
        assert notches(runs(noise(seed, at=[40.0]), noise(seed + 1, at=[40.0]), noise(seed + 2))) == ()


def test_a_shallow_one_or_one_where_pulses_leave_gaps_is_none(runs: Callable[..., list[Observed]]) -> None:
    shallow = [noise(seed, at=[60.0]) + 0.7 * noise(seed + 10) for seed in (1, 2, 3)]  # a third of the power is left
    assert notches(runs(*shallow)) == ()
    assert notches(runs(*(noise(seed, at=[130.0]) for seed in (1, 2, 3)))) == ()


def test_one_run_tells_nothing_nor_do_moments_that_were_filled_in(runs: Callable[..., list[Observed]]) -> None:
    one, other = runs(noise(1, at=[40.0]), noise(2, at=[40.0]))
    assert notches([one, other])
    assert notches([one]) == ()
    assert notches([one, replace(other, rebuilt=True)]) == ()


def test_runs_of_another_rate_have_it_at_the_same_frequency(by_hand: ByHand) -> None:
    runs = []
    for rate in (RATE, 2 * RATE):
        values = np.random.default_rng(int(rate)).standard_normal(int(12 * rate))
        torque = lfilter(*iirnotch(40.0, 8.0, rate), values)
        runs.append(by_hand(torque, np.arange(values.size) / rate * 100.0, rate=rate))
    assert notches(runs) == pytest.approx((40.0,), abs=0.5)


def test_short_runs_tell_no_more_than_their_bins(by_hand: ByHand) -> None:
    """Stretches of a third of a second have bins of 3 Hz: below 80 Hz too few stand on the sides of any."""
    torques = [noise(seed, at=[40.0])[:2000] for seed in (1, 2)]
    assert notches([by_hand(torque, np.arange(2000) / RATE * 100.0, rate=RATE) for torque in torques]) == ()
    still = [by_hand(np.zeros(SAMPLES), np.arange(SAMPLES) / RATE * 100.0, rate=RATE) for _ in range(2)]
    assert notches(still) == ()
