"""Order or fixed frequency at one speed: a wandering speed tells them apart, a steady one leaves it open."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.order_or_fixed import DECIDED, evidence, may_be_fixed, rather_fixed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario

RATE, SAMPLES, SPEED = 2000.0, 16_000, 1000 / 60 * 2 * pi
TIME = np.arange(SAMPLES) / RATE
PLACE = order(16.8)
ByHand = Callable[..., Observed]


def course(wander: float) -> np.ndarray:
    """Turns at 1000 rpm, twice faster and slower by a share within the run."""
    return np.asarray(SPEED * (TIME + wander * np.cos(2 * pi * 0.25 * TIME) / (2 * pi * 0.25)))


def noise(seed: int) -> np.ndarray:
    return 0.05 * np.random.default_rng(seed).standard_normal(SAMPLES)


def turning_line(by_hand: ByHand, *, wander: float, measured: bool = True) -> Observed:
    angle = course(wander)
    return by_hand(noise(1) + 0.02 * np.cos(16.8 * angle), angle, rate=RATE, measured=measured)


def fixed_line(by_hand: ByHand, *, wander: float, measured: bool = True) -> Observed:
    tone = 0.02 * np.cos(16.8 * SPEED * TIME)
    return by_hand(noise(1) + tone, course(wander), rate=RATE, measured=measured)


def test_a_wandering_speed_tells_a_line_that_turns(by_hand: ByHand) -> None:
    run = turning_line(by_hand, wander=5e-3)
    # A^2 T / S: 0.02^2 over a density of 2 * 0.05^2 / 2000 for the two thirds that fits may see, Hann 1.5
    most = 0.02**2 * (TIME[-1] * 2 / 3) / (2 * 0.05**2 / RATE) / 1.5
    assert DECIDED < evidence([run], PLACE) < 1.3 * most


def test_a_wandering_speed_tells_a_line_that_stays(by_hand: ByHand) -> None:
    assert evidence([fixed_line(by_hand, wander=5e-3)], PLACE) < -DECIDED


def test_a_line_that_is_only_near_the_order_is_judged_where_it_stands(by_hand: ByHand) -> None:
    """Nobody measured the speed, so that the whole order nearest to a tone may lie a dozen bins beside it."""
    near, at, strays = order(40.0), 40.1, course(2e-3)
    turning, still = 0.02 * np.cos(at * strays), 0.02 * np.cos(at * SPEED * TIME)
    turns, stays = (by_hand(noise(1) + each, strays, rate=RATE, measured=False) for each in (turning, still))
    assert (at - near.at) * SPEED / (2 * pi) > 8 / (TIME[-1] * 2 / 3)
    assert evidence([turns], near) > DECIDED
    assert evidence([stays], near) < -DECIDED


@pytest.mark.parametrize("line", [turning_line, fixed_line])
def test_a_steady_speed_leaves_it_open(line: Callable[..., Observed], by_hand: ByHand) -> None:
    assert abs(evidence([line(by_hand, wander=0.0)], PLACE)) < 1e-6


def test_chance_in_the_floor_decides_nothing_of_a_strong_line(by_hand: ByHand) -> None:
    """One in which a tone is 40 dB above the noise, and a wander that smears it by next to nothing."""
    tone = 1.0 * np.cos(16.8 * SPEED * TIME)
    decided = [evidence([by_hand(noise(seed) + tone, course(2e-5), rate=RATE)], PLACE) > DECIDED for seed in range(5)]
    assert not any(decided)


def test_only_a_measured_angle_may_speak_against_an_order(by_hand: ByHand) -> None:
    assert rather_fixed([fixed_line(by_hand, wander=5e-3)], PLACE)
    assert not rather_fixed([fixed_line(by_hand, wander=5e-3, measured=False)], PLACE)
    assert not rather_fixed([turning_line(by_hand, wander=5e-3)], PLACE)


def test_a_line_of_one_steady_speed_may_be_fixed(by_hand: ByHand, wear_rig: Scenario) -> None:
    run = turning_line(by_hand, wander=0.0)
    peak = Peak(PLACE, excess=100.0, runs=(run.name,), speeds=1)
    assert may_be_fixed([run], peak, [], wear_rig.rig)
    assert not may_be_fixed([turning_line(by_hand, wander=5e-3)], peak, [], wear_rig.rig)


def test_another_speed_tells_unless_a_known_line_hides_the_tone(by_hand: ByHand, wear_rig: Scenario) -> None:
    """At 700 rpm 280 Hz is order 24, which a rig with that line would show anyway."""
    run, slower = turning_line(by_hand, wander=0.0), by_hand(noise(2), 0.7 * course(0.0), rate=RATE, name="slower")
    peak = Peak(PLACE, excess=100.0, runs=(run.name,), speeds=1)
    assert not may_be_fixed([run, slower], peak, [order(6.0)], wear_rig.rig)
    assert may_be_fixed([run, slower], peak, [order(24.0)], wear_rig.rig)


def test_another_speed_tells_nothing_where_its_noise_would_bury_the_tone(by_hand: ByHand, wear_rig: Scenario) -> None:
    run = turning_line(by_hand, wander=0.0)
    peak = Peak(PLACE, excess=100.0, runs=(run.name,), speeds=1)
    loud = by_hand(20 * noise(2), 0.7 * course(0.0), rate=RATE, name="loaded")
    assert may_be_fixed([run, loud], peak, [], wear_rig.rig)


def test_a_strong_tone_between_two_bins_is_not_taken_for_one_that_turns(by_hand: ByHand) -> None:
    """An angle that ends half a turn of the line off moves its line by half a bin, as a window reads 28 % more."""
    seen = [stretch for stretch in turning_line(by_hand, wander=0.0).stretches if not stretch.held]
    lasts = (seen[-1].stop - seen[0].start) / RATE
    angle = course(0.0) + np.where((seen[-1].stop - 1.5) / RATE < TIME, -pi / 16.8, 0.0)
    tone = 1.0 * np.cos((16.8 * SPEED + pi / lasts) * TIME)
    assert abs(evidence([by_hand(noise(1) + tone, angle, rate=RATE)], PLACE)) < DECIDED
