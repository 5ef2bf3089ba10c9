"""A run less its lines of fixed frequency: the tone goes, the rest stays, and a flight can be seen again."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.flights import CLEARLY, blows
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.without_tones import without_tones
from torquerig.inference.places import frequency, order

RATE, LENGTH = 5000.0, 8.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
ANGLE = 40.0 * TIME
ByHand = Callable[..., Observed]


def test_a_tone_goes_and_a_line_of_the_shaft_stays(by_hand: ByHand) -> None:
    rest = 0.5 + 0.03 * np.cos(7 * ANGLE) + 1e-3 * np.random.default_rng(1).standard_normal(TIME.size)
    wandering = 2 * pi * 50.03 * TIME + 0.3 * np.sin(2 * pi * 0.05 * TIME)
    run = by_hand(rest + 0.2 * np.cos(wandering), ANGLE, rate=RATE)
    left = without_tones(run, [frequency(50.0), order(7.0)]).torque - rest
    inside = slice(int(RATE), -int(RATE))
    # the mean over +-1 s of a phase that turns by d [rad/s] loses some (d s)^2 / 20 of the tone
    assert np.abs(left[inside]).max() < 0.2 * 0.05
    assert np.abs(left).max() < 0.2 * 0.25


def test_a_steady_tone_goes_to_its_ends(by_hand: ByHand) -> None:
    run = by_hand(0.3 * np.cos(2 * pi * 123.4 * TIME + 1.0), ANGLE, rate=RATE)
    assert np.abs(without_tones(run, [frequency(123.4)]).torque).max() < 1e-3
    assert without_tones(run, [order(3.0)]) is run


def test_flights_that_a_hum_hides_are_seen_without_it(by_hand: ByHand) -> None:
    torque = 0.2 + 1e-3 * np.random.default_rng(2).standard_normal(TIME.size)
    for at in np.arange(0.1, LENGTH - 0.1, 0.25):
        since = TIME - at
        torque[(since >= 0) & (since < 0.02)] -= 0.2
        after = since >= 0.02
        torque[after] += 0.4 * np.exp(-(since[after] - 0.02) / 0.005)
    humming = by_hand(torque + 0.1 * np.cos(2 * pi * 60.0 * TIME), ANGLE, rate=RATE)
    assert blows(humming) == []
    quiet = blows(without_tones(humming, [frequency(60.0)]))
    assert len(quiet) >= CLEARLY
    assert quiet == pytest.approx(blows(by_hand(torque, ANGLE, rate=RATE)), abs=10)
