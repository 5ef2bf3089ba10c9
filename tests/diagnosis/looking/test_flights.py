"""Flights of flanks: their distance in closed form, and that a rig has them if and only if it has a gap."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.expecting.simulated import simulated
from torquerig.diagnosis.looking import flights as looking
from torquerig.diagnosis.looking.flight_statistics import flight_misfit, flight_statistics
from torquerig.diagnosis.looking.flights import CLEARLY, blows, flights, flights_counted
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.mechanisms import Backlash
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

RATE = 25_000.0
ARCMIN = pi / 180 / 60
ByHand = Callable[..., Observed]


def parted(by_hand: ByHand, *, flying: float, lasting: float) -> Observed:
    """Contact at 0.2 N m, then ``flying`` [N m] for ``lasting`` [s] and a blow, four times a second."""
    time = np.arange(int(6 * RATE)) / RATE
    torque = np.full(time.size, 0.2)
    for at in np.arange(0.1, 5.9, 0.25):
        since = time - at
        torque[(since >= 0) & (since < lasting)] = flying
        after = since >= lasting
        torque[after] = 0.2 + 0.4 * np.exp(-(since[after] - lasting) / 0.005)
    noise = 1e-3 * np.random.default_rng(1).standard_normal(time.size)
    return by_hand(torque + noise, 40.0 * time, rate=RATE)


def test_a_flight_goes_as_far_as_the_sensors_torque_slows_the_gear_down(by_hand: ByHand, wear_rig: Scenario) -> None:
    seen = parted(by_hand, flying=0.012, lasting=0.02)
    found = flights(seen, wear_rig.rig)
    assert len(found) >= CLEARLY
    inertia = 0.0007  # of the shipped gearbox at its output; the motor turns on at one speed
    expected = 0.5 * 0.012 / inertia * 0.02**2
    assert np.median([each.distance for each in found]) == pytest.approx(expected, rel=0.1)
    assert np.median([each.stop - each.start for each in found]) == pytest.approx(0.02 * RATE, rel=0.05)


def test_no_flight_is_seen_in_what_is_held_out(by_hand: ByHand) -> None:
    seen = parted(by_hand, flying=0.0, lasting=0.02)
    every, shown, held = (blows(seen, held=held) for held in (None, False, True))
    assert sorted([*shown, *held]) == every
    assert shown
    assert held
    assert all(any(one.start <= at < one.stop and not one.held for one in seen.stretches) for at in shown)


@pytest.mark.parametrize("flying", [0.1, 0.012])
def test_a_torque_that_stays_high_or_passes_zero_in_haste_is_no_flight(by_hand: ByHand, flying: float) -> None:
    seen = parted(by_hand, flying=flying, lasting=0.02 if flying > 0.05 else 0.003)
    assert blows(seen) == []


@pytest.mark.parametrize(("lasting", "twice"), [(0.02, True), (0.008, False)])
def test_long_flights_count_twice(lasting: float, twice: bool, by_hand: ByHand) -> None:
    seen = parted(by_hand, flying=0.0, lasting=lasting)
    assert flights_counted(seen) == (2 if twice else 1) * len(blows(seen)) > 0


@pytest.mark.parametrize(("rising", "flies"), [(0.0, True), (0.02, False)])
def test_under_much_noise_the_shoulder_of_a_wave_is_no_flight(rising: float, flies: bool, by_hand: ByHand) -> None:
    time = np.arange(int(6 * RATE)) / RATE
    torque = np.full(time.size, 0.2)
    for at in np.arange(0.1, 5.9, 0.25):
        since = time - at
        torque = np.where((since >= 0) & (since < 0.006), rising * (since / 0.006 - 0.5), torque)
    noisy = torque + 0.0096 * np.random.default_rng(1).standard_normal(time.size)
    assert (len(blows(by_hand(noisy, 40.0 * time, rate=RATE))) >= CLEARLY) is flies


@pytest.fixture(scope="module")
def turning_back(wear_rig: Scenario, record: Callable[..., Recording]) -> Observed:
    recording = record(wear_rig.rig, 3, rpm=600.0, occupancy=0.0, profile="reversal", duration=6.0, rate=RATE)
    angle = recording.channels["encoder_count"].in_si()
    from torquerig.diagnosis.looking.observed import observed

    return observed(recording, ShaftAngle(angle, True, "by the encoder"), ratio=5.0)


def test_flanks_fly_where_there_is_a_gap_and_nowhere_else(wear_rig: Scenario, turning_back: Observed) -> None:
    closed = simulated(wear_rig.rig, turning_back, seed=5)
    narrow, wide = (
        simulated(wear_rig.rig + Backlash(name="backlash", gap=gap * ARCMIN), turning_back, seed=5)
        for gap in (6.0, 30.0)
    )
    assert blows(closed, held=None) == []
    assert min(len(blows(each, held=None)) for each in (narrow, wide)) >= CLEARLY
    told = [flight_statistics(each, wear_rig.rig) for each in (narrow, wide)]
    assert told[1][-1] > told[0][-1] + 0.5, "a wider gap lets them fly further"
    assert np.exp(told[0][-1]) < 1.6 * 6.0, "and none flies much further than the gap is wide"
    assert (flight_misfit(told[0], told[1]) ** 2).sum() > 10 * (flight_misfit(told[0], told[0] + 0.01) ** 2).sum()


def test_a_step_of_coarse_codes_is_no_blow(by_hand: ByHand, monkeypatch: pytest.MonkeyPatch) -> None:
    """A torque near zero stays at one code, and then takes the next, whatever noise its rare steps are taken for."""
    monkeypatch.setattr(looking, "noise_of", lambda _: 5e-3)
    time = np.arange(int(6 * RATE)) / RATE
    slow = 0.06 + 0.05 * np.sin(2 * pi * 3 * time) + 2e-4 * np.random.default_rng(2).standard_normal(time.size)
    assert blows(by_hand(slow, 40.0 * time, rate=RATE)) == []
    assert blows(by_hand(0.104 * np.round(slow / 0.104), 40.0 * time, rate=RATE)) == []
    mended = 0.104 * np.round(slow / 0.104)
    for start in range(9_000, mended.size - 300, 9_000):  # moments without signal, lines drawn through them
        mended[start : start + 300] = np.linspace(mended[start], mended[start + 299], 300)
    assert blows(by_hand(mended, 40.0 * time, rate=RATE)) == []
    struck = parted(by_hand, flying=0.0, lasting=0.02)
    coarse = replace(struck, torque=4e-3 * np.round(struck.torque / 4e-3))
    assert len(blows(coarse)) >= CLEARLY


def test_a_run_without_noise_or_shorter_than_a_blow_has_no_flights(by_hand: ByHand) -> None:
    still = by_hand(np.zeros(60_000), np.linspace(0, 100, 60_000), rate=RATE)
    assert blows(still) == []
    short = replace(still, torque=still.torque[:10], stretches=())
    assert blows(short) == []
