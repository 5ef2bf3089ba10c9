"""Tones that pass for a comb of the shaft at one speed: told by the shaft's own lines, or left open."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.common_tones import common_tones, lead_astray, tone_of
from torquerig.diagnosis.looking.lines_left import known_places, lines_left
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.opening import followed
from torquerig.inference.places import frequency, order
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

RATE, OFF, SPEED = 5000.0, 1.004, 1000 * pi / 30  # `record` turns faster than its sheet says by OFF
HARMONICS = (1, 2, 3, 4)
NEAR, ON = 280.0, 280.0 * OFF  # [Hz]: what the sheet takes for order 84 of the output, and what is


@pytest.fixture(scope="module")
def plain(wear_rig: Scenario, record: Callable[..., Recording]) -> list[Recording]:
    return [
        record(wear_rig.rig, seed, occupancy=load, encoder=False, duration=8.0) for seed, load in ((3, 5.0), (4, 15.0))
    ]


def hummed(recordings: Sequence[Recording], at: float) -> list[Recording]:
    """The same with a comb of fixed frequency, as a pick-up or an alias adds it."""
    answer = []
    for recording in recordings:
        time = np.arange(recording.samples) / RATE
        comb = sum(0.05 / k * np.cos(2 * pi * k * at * time + k) for k in HARMONICS)
        answer.append(recording.with_values("torque_V", recording.channels["torque_V"].values + comb))
    return answer


def factors(runs: Sequence[Observed]) -> list[float]:
    return [run.mean_speed / SPEED for run in runs]


@pytest.fixture(scope="module")
def led(plain: list[Recording], wear_rig: Scenario) -> tuple[Observed, ...]:
    recordings = hummed(plain, NEAR)
    return followed(recordings, recordings, wear_rig.rig)


@pytest.mark.long
def test_the_shaft_is_followed_by_its_own_lines(led: tuple[Observed, ...]) -> None:
    assert factors(led) == pytest.approx([OFF, OFF], abs=3e-4)
    assert common_tones(led) == pytest.approx([NEAR * k for k in HARMONICS], abs=0.02)


def test_its_lines_are_then_tones_and_no_orders(led: tuple[Observed, ...], wear_rig: Scenario) -> None:
    left = lines_left(led, known_places(led, wear_rig.rig), rig=wear_rig.rig)
    places = sorted(peak.place for peak in left[: len(HARMONICS)])
    assert {place.domain for place in places} == {"frequency"}
    assert [place.at for place in places] == pytest.approx([NEAR * k for k in HARMONICS], abs=2e-3)


@pytest.mark.long
def test_a_comb_that_stands_on_a_whole_order_is_left_open(plain: list[Recording], wear_rig: Scenario) -> None:
    recordings = hummed(plain, ON)
    runs = followed(recordings, recordings, wear_rig.rig)
    assert len(common_tones(runs)) >= len(HARMONICS)
    assert all(run.tones == () for run in runs)
    assert factors(runs) == pytest.approx([OFF, OFF], abs=3e-4)


def test_runs_without_such_a_comb_have_none(plain: list[Recording], wear_rig: Scenario) -> None:
    runs = followed(plain, plain, wear_rig.rig)
    assert all(run.tones == () for run in runs)


def test_neither_an_encoder_nor_another_speed_needs_them(led: tuple[Observed, ...]) -> None:
    assert len(common_tones(led)) == len(HARMONICS)
    assert common_tones(led[:1]) == ()
    assert common_tones([replace(run, angle_measured=True) for run in led]) == ()
    slower = replace(led[1], angle=0.7 * led[1].angle, speed=0.7 * led[1].speed)
    assert common_tones([led[0], slower]) == ()


def test_a_tone_on_a_line_of_the_shaft_leaves_it_open(led: tuple[Observed, ...], wear_rig: Scenario) -> None:
    """The same angles decide without it: the wrong one turns as the sheet says."""
    wrong = [replace(run, angle=run.angle / OFF) for run in led]
    own, tones = [place.at for place in known_places(led, wear_rig.rig)], common_tones(led)
    assert lead_astray(wrong, led, tones, own)
    assert not lead_astray(led, wrong, tones, own)
    assert not lead_astray(wrong, led, (*tones, own[-1] * led[0].mean_speed / (2 * pi)), own)


def test_multiples_of_a_tone_are_tones(led: tuple[Observed, ...]) -> None:
    speed = led[0].mean_speed
    led = tuple(replace(run, tones=common_tones(led)) for run in led)
    assert tone_of(led, frequency(6 * NEAR + 0.1)) == frequency(2 * led[0].tones[2])
    assert tone_of(led, order(NEAR * 2 * pi / speed)) == frequency(led[0].tones[0])
    assert tone_of(led, order(16.8)) is None
    assert tone_of([replace(run, tones=()) for run in led], frequency(NEAR)) is None
