"""Two lines that stand so close that a stretch hardly, or not at all, tells them apart."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.smeared import gathered
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import frequency, order

RATE, SAMPLES = 2000.0, 24_000
TIME = np.arange(SAMPLES) / RATE
STRETCH = SAMPLES / 6 / RATE  # [s]
TURNS = 1003.0 / 60  # [1/s]
ByHand = Callable[..., Observed]


def beside_order_three(by_hand: ByHand, bins: float, *, size: float) -> Observed:
    """Order 3 of 0.02 and a fixed line so many bins of a stretch above it, in noise of 0.05."""
    angle = 2 * pi * TURNS * TIME
    fixed = 3 * TURNS + bins / STRETCH
    torque = 0.02 * np.cos(3 * angle) + size * np.cos(2 * pi * fixed * TIME + 0.4)
    noise = 0.05 * np.random.default_rng(4).standard_normal(SAMPLES)
    return by_hand(torque + noise, angle, rate=RATE, name="run")


def test_lines_eight_tenths_of_a_bin_apart_are_two(by_hand: ByHand) -> None:
    run = beside_order_three(by_hand, 0.8, size=0.13)
    seen = features(run, [order(3.0), frequency(3 * TURNS + 0.8 / STRETCH)])
    small, large = np.sqrt(np.mean(np.abs(seen.amplitude) ** 2, axis=0))
    spread = np.sqrt(1.5 * seen.widening * 2 * 0.05**2 / RATE / STRETCH)  # of each part of an amplitude
    assert (seen.widening > 1.3).all()  # and each costs the other some of its certainty
    assert large == pytest.approx(0.13, abs=3 * spread.max())
    assert small == pytest.approx(0.02, abs=3 * spread.max())


def test_a_guest_shows_as_much_as_the_window_lets_through(by_hand: ByHand) -> None:
    """Half a bin away a Hann window leaves 8 / (3 pi) = 0.849 of a line."""
    run = beside_order_three(by_hand, 0.5, size=0.13)
    seen = features(run, [order(3.0)])
    route = seen.route(frequency(3 * TURNS + 0.5 / STRETCH))
    assert route.guest.all()
    assert route.part == pytest.approx(8 / (3 * pi), abs=0.01)
    assert np.abs(seen.amplitude[:, 0]).mean() == pytest.approx(0.849 * 0.13, abs=0.02)  # the order itself: 0.02


def test_widening_is_one_for_a_line_alone_and_as_predicted_for_two() -> None:
    """Two waves whose product averages to c over the stretch: the variance of each grows by 1 / (1 - |c|^2)."""
    time, apart = np.linspace(0.0, 1.0, 4000, endpoint=False), 0.6
    one, two = (np.exp(2j * pi * at * time) for at in (40.0, 40.0 + apart))
    assert regressed(one.real, Waves([frequency(40.0)], time, time)).widening == pytest.approx([1.0], rel=1e-3)
    overlap = abs(np.mean(one.conj() * two))
    both = regressed(one.real, Waves([frequency(40.0), frequency(40.0 + apart)], time, time))
    assert both.widening == pytest.approx([1 / (1 - overlap**2)] * 2, rel=0.03)


def test_what_was_gathered_tells_how_far_it_reached_and_on_what_it_stood() -> None:
    rng = np.random.default_rng(2)
    values = 0.3 * np.cos(2 * pi * 250.0 * TIME) + 0.05 * rng.standard_normal(SAMPLES)
    (line,) = gathered(values, RATE, [250.0], smeared=0.012)
    assert line.reach == pytest.approx(0.012 * 250.0 * SAMPLES / RATE)  # no neighbour holds it back
    assert line.floor == pytest.approx(2 * 0.05**2 / RATE, rel=0.3)  # white noise, one-sided, some 70 bins
    assert line.amplitude == pytest.approx(0.3, rel=0.02)


def test_a_tone_beneath_an_order_is_taken_out_of_what_the_lines_leave(by_hand: ByHand) -> None:
    """As the speed wanders, the order's own wave takes up a part of it and leaves ten times the noise beside it."""
    angle = 2 * pi * TURNS * TIME + 0.08 * np.sin(2 * pi * 1.7 * TIME)
    fixed = 15 * TURNS + 0.1 / STRETCH
    noise = 0.02 * np.random.default_rng(4).standard_normal(SAMPLES)
    torque = 0.05 * np.cos(15 * angle) + 0.2 * np.cos(2 * pi * fixed * TIME + 0.4) + noise
    run = by_hand(torque, angle, rate=RATE, name="run")
    alone, both = (features(run, places) for places in ([order(15.0)], [order(15.0), frequency(fixed)]))
    near = int(np.argmin(np.abs(both.band - fixed)))
    white = 2 * 0.02**2 / RATE
    assert alone.power[near] > 10 * white
    assert both.power[near] == pytest.approx(white, rel=0.25)
    assert np.isnan(both.amplitude[:, 1]).all()  # its amplitude cannot be told beside the order


def test_a_tone_beneath_a_tone_is_one_with_it(by_hand: ByHand) -> None:
    run = beside_order_three(by_hand, 5.0, size=0.13)
    tone, near = (frequency(3 * TURNS + bins / STRETCH) for bins in (5.0, 5.3))
    alone, both = (features(run, places).power for places in ([tone], [tone, near]))
    assert np.array_equal(alone, both)
