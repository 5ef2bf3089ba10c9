"""Where a tone stands is told by all runs together, to the bound of its noise, and by none with a shaft's line near."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, sqrt

import numpy as np
import pytest

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.tone_frequency import told_frequency
from torquerig.inference.places import order

RATE, LENGTH, TONE = 5000.0, 12.0, 50.0108
TIME = np.arange(int(RATE * LENGTH)) / RATE
Made = Callable[..., Observed]


@pytest.fixture
def made(by_hand: Callable[..., Observed]) -> Made:
    """A run with a tone, noise, and a line of this order of the motor."""

    def run(speed: float, *, seed: int, line: float = 0.0, size: float = 0.0) -> Observed:
        rng = np.random.default_rng(seed)
        torque = 0.1 * np.cos(2 * pi * TONE * TIME + rng.uniform(0, 2 * pi)) + 2e-2 * rng.standard_normal(TIME.size)
        torque += size * np.cos(line * speed * TIME + rng.uniform(0, 2 * pi))
        return by_hand(torque, speed * TIME, rate=RATE, name=f"{speed:g}")

    return run


def test_several_runs_tell_it_to_the_bound(made: Made) -> None:
    """Rife and Boorstyn's bound of the variance, 6 s^2 fs^2 / (pi^2 A^2 N^3); a Hann window takes some of it."""
    runs = [made(speed, seed=seed) for seed, speed in enumerate((100.0, 81.0, 63.0))]
    seen = int(2 / 3 * TIME.size)
    bound = sqrt(6 * (2e-2) ** 2 * RATE**2 / (pi**2 * 0.1**2 * seen**3) / len(runs))
    errors = [
        told_frequency(TONE + off, [made(speed, seed=10 * k + s) for s, speed in enumerate((100.0, 81.0, 63.0))], ())
        - TONE
        for k, off in enumerate((-0.03, -0.01, 0.004, 0.02, 0.05))
    ]
    assert np.std(errors) < 3 * bound
    assert abs(told_frequency(TONE - 0.02, runs, ()) - TONE) < 6 * bound


def test_a_run_with_a_line_of_the_shaft_beside_is_not_asked(made: Made) -> None:
    near = (TONE + 0.12) * 2 * pi / 100.0  # the order that passes by at this speed
    disturbed, clear = made(100.0, seed=1, line=near, size=0.1), made(70.0, seed=2, line=near, size=0.1)
    assert abs(told_frequency(TONE - 0.02, [disturbed, clear], ()) - TONE) > 2e-3
    assert abs(told_frequency(TONE - 0.02, [disturbed, clear], [order(near)]) - TONE) < 5e-4


def test_what_no_run_tells_stays_where_it_was_seen(made: Made) -> None:
    near = (TONE + 0.12) * 2 * pi / 100.0
    assert told_frequency(TONE - 0.02, [made(100.0, seed=1, line=near, size=0.1)], [order(near)]) == TONE - 0.02
    assert told_frequency(TONE, [], ()) == TONE
