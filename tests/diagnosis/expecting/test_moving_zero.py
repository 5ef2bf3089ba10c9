"""A zero that moves: in steady runs, in what is held out of them, and in runs that turn back."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.expecting.simulated import expected_by_simulation, simulated
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import SensorDrift
from torquerig.scenario.model import Scenario

RATE, SPAN, TAU = 5000.0, 0.5, 1.3
DRIFT = SensorDrift(name="drift", span=SPAN, time_constant=TAU)
ByHand = Callable[..., Observed]


def settled(start: np.ndarray, stop: np.ndarray) -> np.ndarray:
    """Mean of ``SPAN (1 - exp(-t / TAU))`` between two times [s]."""
    return np.asarray(SPAN * (1 + TAU * (np.exp(-stop / TAU) - np.exp(-start / TAU)) / (stop - start)))


def idle(by_hand: ByHand, wear_rig: Scenario) -> Observed:
    time = np.arange(int(8 * RATE)) / RATE
    bare = by_hand(np.zeros(time.size), 700 * pi / 30 * time, rate=RATE)
    run = replace(wear_rig.rig.run, speed=700 * pi / 30, occupancy_percent=0.0, profile="steady")
    return replace(bare, recording=replace(bare.recording, run=run))


def test_simulations_tell_the_zero_where_it_is_held_out(by_hand: ByHand, wear_rig: Scenario) -> None:
    rig = wear_rig.rig + DRIFT
    measured = simulated(rig, idle(by_hand, wear_rig), seed=7)
    for held in (False, True):
        seen = features(measured, [], held=held)
        (told,) = expected_by_simulation(rig, [seen], seeds=(1, 2))
        assert told.level == pytest.approx(seen.level, abs=0.06), held  # the idle load varies slowly by 0.02
        assert np.mean(told.level) == pytest.approx(np.mean(seen.level), abs=0.03), held
    assert seen.level.mean() > np.mean(features(measured, []).level) + 0.1, "it has risen by then"


def test_the_zero_moves_in_runs_that_turn_back(by_hand: ByHand, wear_rig: Scenario) -> None:
    time = np.arange(int(6 * RATE)) / RATE
    angle = np.cumsum(60.0 * np.sin(2 * pi * 2 / 6 * time)) / RATE
    seen = features(by_hand(np.zeros(time.size), angle, rate=RATE, profile="reversal"), [])
    assert seen.turning is not None
    still, moving = (expected(rig, seen).turning for rig in (wear_rig.rig, wear_rig.rig + DRIFT))
    assert still is not None
    assert moving is not None
    start = seen.turning.start / RATE
    assert moving - still == pytest.approx(settled(start, start + seen.turning.size / RATE), abs=0.01)
