"""Waves that meet near zero look like a flight once a turn; the lines of the run tell them from real ones."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.flights import CLEARLY, flights_counted
from torquerig.diagnosis.looking.flights_beyond_lines import flights_beyond_lines
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order

RATE, SPEED, LENGTH = 25_000.0, 40.0, 6.0
ByHand = Callable[..., Observed]
TURNS = SPEED * np.arange(int(RATE * LENGTH)) / RATE / (2 * pi)
NOISE = 1e-3 * np.random.default_rng(1).standard_normal(TURNS.size)


def resting_once_a_turn(highest: int, *, astray: float = 0.0) -> tuple[np.ndarray, list[float]]:
    """A torque that rests at zero for a twelfth of a turn and then rises, made of orders up to ``highest`` alone.

    In each turn at another angle, by so much of a turn ``astray``.
    """
    turn = np.arange(4096) / 4096
    drawn = np.where(turn < 1 / 12, 0.0, 0.4 * np.sqrt(np.abs(np.sin(pi * (turn - 1 / 12) / (11 / 12)))))
    kept = np.fft.rfft(drawn)
    kept[highest + 1 :] = 0.0
    off = astray * np.random.default_rng(2).uniform(-1, 1, int(TURNS[-1]) + 2)[(TURNS + 0.5).astype(int)]
    return np.interp((TURNS + off) % 1, turn, np.fft.irfft(kept, 4096), period=1.0), [
        float(n) for n in range(1, highest + 1)
    ]


@pytest.mark.long
def test_waves_that_rest_near_zero_are_no_flights(by_hand: ByHand) -> None:
    torque, orders = resting_once_a_turn(60)
    seen = features(by_hand(torque + NOISE, 2 * pi * TURNS, rate=RATE), [order(each) for each in orders])
    assert flights_counted(seen.untoned) >= CLEARLY
    assert flights_beyond_lines(seen) < CLEARLY


def test_rests_at_one_angle_in_turn_after_turn_are_waves(by_hand: ByHand) -> None:
    """The same rest and rise, of which the model has the lowest lines alone."""
    torque, orders = resting_once_a_turn(60)
    seen = features(by_hand(torque + NOISE, 2 * pi * TURNS, rate=RATE), [order(each) for each in orders[:4]])
    assert flights_counted(seen.untoned) >= CLEARLY
    assert flights_beyond_lines(seen) < CLEARLY


def test_blows_at_other_angles_in_every_turn_are_flights(by_hand: ByHand) -> None:
    torque, orders = resting_once_a_turn(60, astray=0.2)
    seen = features(by_hand(torque + NOISE, 2 * pi * TURNS, rate=RATE), [order(each) for each in orders[:4]])
    assert flights_beyond_lines(seen) == flights_counted(seen.untoned) >= CLEARLY
