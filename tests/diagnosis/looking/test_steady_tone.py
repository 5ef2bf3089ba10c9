"""Of a tone that sounds for a share of the time, that share of its power is left in its line."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.steady_tone import _share_in_line, sounds_all_along
from torquerig.inference.places import frequency, order

RATE, SAMPLES = 5000.0, 60_000
TIME = np.arange(SAMPLES) / RATE
ANGLE = 1000 * pi / 30 * TIME
ByHand = Callable[..., Observed]


def run(by_hand: ByHand, wave: np.ndarray) -> Observed:
    noise = 0.005 * np.random.default_rng(1).standard_normal(SAMPLES)
    return by_hand(noise + 0.1 * np.cos(12 * ANGLE) + wave, ANGLE, rate=RATE, name="run1")


@pytest.mark.parametrize("share", [0.2, 0.4])
def test_bursts_keep_their_share_in_the_line(share: float, by_hand: ByHand) -> None:
    rng = np.random.default_rng(2)
    on = np.repeat(rng.random(SAMPLES // 250) < share, 250)  # bursts of 50 ms and their multiples
    seen = run(by_hand, 0.1 * on * np.cos(2 * pi * 733.0 * TIME))
    assert _share_in_line(seen, 733.0, [order(12.0)]) == pytest.approx(share, abs=0.12)
    assert not sounds_all_along(Peak(frequency(733.0), 90.0, ("run1",), 2), [seen], [order(12.0)])


def test_a_run_whose_time_base_is_broken_tells_nothing_of_bursts(by_hand: ByHand) -> None:
    """A tone that falls behind by a third of its period twice a second loses its line, and never paused."""
    late = TIME - np.floor(2 * TIME) / (3 * 733.0)
    seen, peak = run(by_hand, 0.1 * np.cos(2 * pi * 733.0 * late)), Peak(frequency(733.0), 90.0, ("run1",), 2)
    assert not sounds_all_along(peak, [seen], [order(12.0)])
    assert sounds_all_along(peak, [replace(seen, broken=True)], [order(12.0)])


@pytest.mark.parametrize("size", [0.002, 0.1])
def test_a_steady_tone_keeps_nearly_all(size: float, by_hand: ByHand) -> None:
    seen = run(by_hand, size * np.cos(2 * pi * 733.0 * TIME))
    assert sounds_all_along(Peak(frequency(733.0), 90.0, ("run1",), 2), [seen], [order(12.0)])


def test_a_floor_that_falls_with_frequency_is_not_taken_for_bursts(by_hand: ByHand) -> None:
    """A weak hum stands in the noise of the load, ten times as strong below it as above."""
    load = lfilter([0.05], [1.0, -0.995], np.random.default_rng(3).standard_normal(SAMPLES))  # falls beyond 4 Hz
    seen = run(by_hand, load + 0.008 * np.cos(2 * pi * 50.0 * TIME))
    assert sounds_all_along(Peak(frequency(50.0), 60.0, ("run1",), 1), [seen], [order(12.0)])


def test_a_known_line_beside_it_is_not_taken_for_bursts(by_hand: ByHand) -> None:
    seen = run(by_hand, 0.01 * np.cos(2 * pi * 203.0 * TIME))  # 3 Hz beside order 12
    assert sounds_all_along(Peak(frequency(203.0), 90.0, ("run1",), 2), [seen], [order(12.0)])


def test_side_lines_once_a_turn_are_not_taken_for_bursts(by_hand: ByHand) -> None:
    """A shaft behind 5:1 that runs out leaves lines 0.2 orders beside each other line: 3.3 Hz at 1000 rpm."""
    beside = 0.02 * (np.cos(11.8 * ANGLE) + np.cos(12.2 * ANGLE))
    seen = run(by_hand, 0.01 * np.cos(2 * pi * 201.0 * TIME) + beside)
    peak, known = Peak(frequency(201.0), 90.0, ("run1",), 2), [order(12.0), order(0.2)]
    assert sounds_all_along(peak, [seen], known)
    assert not sounds_all_along(peak, [seen], known[:1])
