"""Lines that no model asked for: orders told from fixed frequencies, strong from weak, and silence in noise."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from torquerig.diagnosis.looking.lines_left import lines_left
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak, _as_a_whole, peaks
from torquerig.inference.places import Place, frequency, order
from torquerig.scenario.model import Scenario

RATE, SAMPLES = 2000.0, 16_000
TIME = np.arange(SAMPLES) / RATE
ByHand = Callable[..., Observed]


def turned(rpm: float) -> np.ndarray:
    return rpm / 60 * 2 * pi * TIME


def noise(seed: int) -> np.ndarray:
    return 0.05 * np.random.default_rng(seed).standard_normal(SAMPLES)


def two_speeds(by_hand: ByHand, wave: Callable[[np.ndarray], np.ndarray]) -> list[Observed]:
    return [
        by_hand(noise(seed) + wave(turned(rpm)), turned(rpm), rate=RATE, name=f"{rpm:g}")
        for seed, rpm in ((1, 1003.0), (2, 702.0))
    ]


@pytest.mark.parametrize("at", [3.4, 16.8, 21.0])
def test_an_order_stands_at_its_order_at_two_speeds(at: float, by_hand: ByHand) -> None:
    found = peaks(two_speeds(by_hand, lambda angle: 0.03 * np.cos(at * angle + 1)), [])
    assert len(found) == 1
    assert found[0].place.domain == "order"
    # a bin is one turn over those seen, 89 at 1003 rpm; a peak is placed to a tenth of it
    assert found[0].place.at == pytest.approx(at, abs=0.1 / 89)
    assert found[0].speeds == 2
    assert found[0].runs == ("1003", "702")


@pytest.mark.parametrize("at", [50.0, 233.3, 961.7])  # an alias may stand anywhere below half the sample rate
def test_a_fixed_line_stands_at_its_frequency_at_two_speeds(at: float, by_hand: ByHand) -> None:
    found = peaks(two_speeds(by_hand, lambda _: 0.03 * np.cos(2 * pi * at * TIME)), [])
    assert [peak.place.domain for peak in found] == ["frequency"]
    assert found[0].place.at == pytest.approx(at, abs=0.1 * RATE / (SAMPLES * 2 / 3))


def test_both_are_told_apart_where_they_stand_together(by_hand: ByHand) -> None:
    found = peaks(
        two_speeds(by_hand, lambda angle: 0.04 * np.cos(7 * angle) + 0.03 * np.cos(2 * pi * 150.2 * TIME)), []
    )
    assert sorted((peak.place.domain, round(peak.place.at, 1)) for peak in found) == [
        ("frequency", 150.2), ("order", 7.0),
    ]  # fmt: skip


def test_a_known_line_is_no_peak(by_hand: ByHand) -> None:
    runs = two_speeds(by_hand, lambda angle: 0.5 * np.cos(6 * angle))
    assert peaks(runs, [order(6.0)]) == ()


@pytest.mark.parametrize("seed", range(20))
def test_noise_alone_has_no_lines(seed: int, by_hand: ByHand, wear_rig: Scenario) -> None:
    """White, and coloured as shafts colour it: no place among some ten thousand passes the threshold."""
    from scipy.signal import lfilter

    white = noise(100 + seed)
    ringing = lfilter([1.0], [1.0, -2 * 0.97 * np.cos(2 * pi * 90 / RATE), 0.97**2], white)
    runs = [
        by_hand(white, turned(1000.0), rate=RATE, name="white"),
        by_hand(ringing, turned(700.0), rate=RATE, name="ringing"),
    ]
    assert lines_left(runs, [], rig=wear_rig.rig) == ()


def test_a_weak_line_beside_a_strong_one_is_found_in_a_later_pass(by_hand: ByHand, wear_rig: Scenario) -> None:
    runs = two_speeds(by_hand, lambda angle: 2.0 * np.cos(16.8 * angle) + 0.02 * np.cos(20.0 * angle))
    found = lines_left(runs, [], rig=wear_rig.rig)
    assert found[0].place == order(16.8)
    assert order(20.0) in [peak.place for peak in found]


def test_at_one_speed_a_whole_output_order_wins_over_its_frequency(by_hand: ByHand, wear_rig: Scenario) -> None:
    runs = two_speeds(by_hand, lambda angle: 0.03 * np.cos(16.8 * angle))[:1]
    assert [peak.place for peak in lines_left(runs, [], rig=wear_rig.rig)] == [order(16.8)]


def test_a_place_says_where_it_stands_and_how_its_phase_runs() -> None:
    speed = 2 * pi * 10
    assert order(3.0).frequency(speed) == order(3.0).frequency(-speed) == pytest.approx(30.0)
    assert frequency(50.0).frequency(speed) == 50.0
    time = np.array([0.0, 0.01])
    assert order(3.0).phase(speed * time, time) == pytest.approx(frequency(30.0).phase(speed * time, time))
    assert order(1 / 3) == Place("order", 0.333333333)


@pytest.mark.parametrize(("first", "told"), [(0.3, 43.2), (0.0, 43.0)])
def test_a_harmonic_that_an_unmeasured_angle_shifts_stands_on_its_order(
    first: float, told: float, by_hand: ByHand, wear_rig: Scenario
) -> None:
    """Between two whole orders of the output, 215 and 216, the third harmonic of 72 is meant where 72 stands out."""
    runs = []
    for seed, rpm in ((1, 1003.0), (2, 702.0)):
        angle = turned(rpm)
        wave = first * np.cos(14.4 * angle) + 0.03 * np.cos(43.095 * angle)
        runs.append(by_hand(noise(seed) + wave, angle, rate=RATE, name=f"{rpm:g}", measured=False))
    found = [peak.place.at for peak in lines_left(runs, [], rig=wear_rig.rig)]
    assert max(found) == pytest.approx(told)


@pytest.mark.parametrize(
    ("hertz", "power", "smearing", "whole"),
    [(996.7, 1.0, 0.012, True), (996.7, 3.0, 0.012, False), (1020.0, 1.0, 0.012, False), (996.7, 1.0, 0.0, False)],
)
def test_an_order_that_was_followed_stands_out_as_far_as_a_side_line_of_it(
    hertz: float, power: float, smearing: float, whole: bool
) -> None:
    """The floor beside order 60 is its own skirt; in time a sway leaves a side line at 996.7 Hz with half its size."""
    observed = SimpleNamespace(name="run1", smearing=smearing, mean_speed=2 * np.pi * 993.4 / 60.0)
    spectrum = SimpleNamespace(
        observed=observed, power=lambda place: 4.0 if place.domain == "order" else power, excess=lambda _: 0.0
    )
    turning = Peak(order(60.0), excess=611.0, runs=("run1",), speeds=1)
    tone = Peak(frequency(hertz), excess=763.0, runs=("run1",), speeds=1)
    excess = _as_a_whole(turning, [turning, tone], cast(Any, [spectrum]))
    assert excess == (763.0 if whole else 611.0)
    assert _as_a_whole(tone, [turning, tone], cast(Any, [spectrum])) == 763.0
