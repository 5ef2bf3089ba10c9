"""Lines that grow together along the runs tell a gain that changes; noise does not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.diagnosis.judging.growing_lines import growing_lines
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order

RATE, SECONDS = 5000.0, 12.0
PLACES = [order(at) for at in (1.0, 6.0, 7.0)]


@pytest.fixture
def run(by_hand: Callable[..., Observed]) -> Callable[..., Observed]:
    """A steady run of three lines in noise, whose sizes reach ``grows`` times what they begin with."""

    def made(seed: int, *, grows: float = 1.0, noise: float = 0.02) -> Observed:
        rng = np.random.default_rng(seed)
        time = np.arange(int(SECONDS * RATE)) / RATE
        angle = 2 * np.pi * (16.7 - 1.3 * seed) * time
        gain = 1 + (grows - 1) * (1 - np.exp(-time / 4.0))
        torque = noise * rng.standard_normal(time.size)
        for place in PLACES:
            torque += gain * 0.1 * np.cos(place.at * angle + rng.uniform(0, 6.28))
        return by_hand(torque, angle, rate=RATE, name=f"run{seed}")

    return made


def test_a_gain_that_settles_is_told(run: Callable[..., Observed]) -> None:
    ((sentence, mismatch),) = growing_lines([run(seed, grows=1.1) for seed in range(3)], PLACES)
    assert "grow together" in sentence
    assert mismatch.domain == "time"
    assert mismatch.recordings == ("run0", "run1", "run2")
    assert mismatch.excess_dB == pytest.approx(20 * np.log10(1.1), abs=0.4)
    ((sentence, mismatch),) = growing_lines([run(seed, grows=0.9) for seed in range(3)], PLACES)
    assert "fade together" in sentence
    assert mismatch.excess_dB < 0


def test_lines_that_stay_what_they_are_tell_nothing(run: Callable[..., Observed]) -> None:
    for first in range(0, 30, 3):
        assert growing_lines([run(first + at, noise=0.3) for at in range(3)], PLACES) == ()


def test_a_hundredth_is_known_of_no_gain(run: Callable[..., Observed]) -> None:
    assert growing_lines([run(seed, grows=1.01, noise=1e-3) for seed in range(3)], PLACES) == ()


def test_a_run_without_lines_tells_nothing(run: Callable[..., Observed]) -> None:
    assert growing_lines([run(1, grows=1.2)], []) == ()
    assert growing_lines([], PLACES) == ()
