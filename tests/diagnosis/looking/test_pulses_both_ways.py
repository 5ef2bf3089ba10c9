"""A load that comes in pulses opposes the motion either way, which no line of a shaft does."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.pulses_both_ways import lines_of_pulses, pulses_both_ways
from torquerig.inference.places import order

RATE, LENGTH, TURNS = 5000.0, 12.0, 0.2
TIME = np.arange(int(RATE * LENGTH)) / RATE
SPEED = 60.0 * np.sin(2 * pi * 2 / LENGTH * TIME)
ANGLE = np.cumsum(SPEED) / RATE
WAY = np.tanh(SPEED * TURNS / 0.02)
KNOWN = [order(TURNS * at) for at in (1, 2, 3, 4)]
ByHand = Callable[..., Observed]


def pulses(number: int, size: float = 0.1) -> np.ndarray:
    return np.asarray(size * WAY * np.maximum(0.0, np.cos(number * TURNS * ANGLE)) ** 2)


@pytest.fixture
def bed() -> np.ndarray:
    """A load of 1 N m that wanders by 4 %, viscous friction, and a line of the shaft of each known order."""
    rng = np.random.default_rng(5)
    slow = np.repeat(rng.standard_normal(TIME.size // 500), 500)
    lines = sum(0.05 * np.cos(place.at * ANGLE + place.at) for place in KNOWN)
    return np.asarray(WAY * (1.0 + 0.04 * slow) + 0.01 * SPEED * TURNS + lines)


@pytest.mark.parametrize("number", [3, 4, 6])
def test_their_number_is_told_beside_lines_at_the_same_orders(number: int, bed: np.ndarray, by_hand: ByHand) -> None:
    run = by_hand(bed + pulses(number), ANGLE, rate=RATE, profile="reversal")
    told, clear = pulses_both_ways(run, KNOWN, turns=TURNS)
    assert told == number
    assert clear > 25


def test_a_bed_and_lines_that_do_not_turn_their_sign_are_none(bed: np.ndarray, by_hand: ByHand) -> None:
    line = 0.1 * np.cos(3 * TURNS * ANGLE + 1)
    for torque in (bed, bed + line):
        assert pulses_both_ways(by_hand(torque, ANGLE, rate=RATE, profile="reversal"), KNOWN, turns=TURNS)[0] == 0


def test_a_steady_run_is_not_asked(bed: np.ndarray, by_hand: ByHand) -> None:
    run = by_hand(bed + pulses(3), 60.0 * TIME, rate=RATE, profile="steady")
    assert pulses_both_ways(run, KNOWN, turns=TURNS) == (0, 0.0)


def test_of_their_lines_those_beside_the_known_ones_are_left(bed: np.ndarray, by_hand: ByHand) -> None:
    run = by_hand(bed + pulses(3), ANGLE, rate=RATE, profile="reversal")
    assert [peak.place for peak in lines_of_pulses([run], KNOWN, turns=TURNS)] == [order(1.2)]
