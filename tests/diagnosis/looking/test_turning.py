"""A run that turns back: its friction is seen as it is, and lines of the shafts cannot pass for it."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.expecting.simulated import expected_by_simulation
from torquerig.diagnosis.fitting.misfit import misfit
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed, observed
from torquerig.diagnosis.looking.turning import Turning, turning, turns_back
from torquerig.inference.motor_angle.shaft_angle import ShaftAngle
from torquerig.inference.places import frequency, order
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

RATE, LENGTH = 5000.0, 6.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
SPEED = 60.0 * np.sin(2 * pi * 2 / LENGTH * TIME)  # two full periods, as the contract's reversal
ANGLE = np.cumsum(SPEED) / RATE
ByHand = Callable[..., Observed]


def friction(speed: np.ndarray) -> np.ndarray:
    return np.sign(speed) * (0.3 + 0.4 * np.exp(-((speed / 5) ** 2))) + 0.002 * speed


def test_blocks_show_the_friction_curve(by_hand: ByHand) -> None:
    seen = turning(by_hand(friction(SPEED), ANGLE, rate=RATE, profile="reversal"), [], held=None)
    moving = np.abs(seen.speed) > 4  # within a block of standstill the sign changes
    # a block of 20 ms averages the curve over 2.5 rad/s at most
    assert seen.torque[moving] == pytest.approx(friction(seen.speed[moving]), abs=0.06)
    fast = np.abs(seen.speed) > 20
    assert seen.torque[fast] == pytest.approx(friction(seen.speed[fast]), abs=0.004)
    # v = V sin wt gives |a| = w sqrt(V^2 - v^2); the first and last blocks have no speed on one side
    expected = 2 * pi * 2 / LENGTH * np.sqrt(np.maximum(60.0**2 - seen.speed**2, 0.0))
    assert np.abs(seen.acceleration)[3:-3] == pytest.approx(expected[3:-3], abs=8.0)


def test_lines_of_any_phase_are_projected_out(by_hand: ByHand) -> None:
    lines = 0.2 * np.cos(0.2 * ANGLE + 0.3) + 0.1 * np.cos(ANGLE - 1) + 0.05 * np.cos(2 * ANGLE)
    places = [order(0.2), order(1.0), order(2.0)]
    bare, rippled = (
        turning(by_hand(values, ANGLE, rate=RATE, profile="reversal"), places, held=None)
        for values in (friction(SPEED), friction(SPEED) + lines)
    )
    added = rippled.torque - bare.torque
    assert np.abs(added).max() > 0.1
    assert np.abs(rippled.without_lines(added)).max() < 0.01
    curve = bare.without_lines(friction(bare.speed))
    assert np.linalg.norm(curve) > 0.7 * np.linalg.norm(friction(bare.speed)), "the curve must not go with the lines"


@pytest.mark.parametrize("hum", [50.0, 60.0])
def test_a_hum_does_not_show_in_the_blocks(hum: float, by_hand: ByHand) -> None:
    """Blocks of 20 ms hold one period of 50 Hz, and of 60 Hz one and a fifth."""
    bare, humming = (
        features(by_hand(friction(SPEED) + size * np.cos(2 * pi * hum * TIME), ANGLE, rate=RATE, profile="reversal"),
                 [frequency(hum)], held=None).turning
        for size in (0.0, 0.5)
    )  # fmt: skip
    assert bare is not None
    assert humming is not None
    assert humming.torque == pytest.approx(bare.torque, abs=0.01)


def test_a_line_that_passes_a_resonance_leaves_nothing(by_hand: ByHand) -> None:
    """A line of order 14.4 rings at 131 Hz: twenty times as high there, and its phase turns, so no one size fits it."""
    rate = np.abs(SPEED) * 14.4 / (2 * pi * 131.0)
    gain = 1 / (1 - rate**2 + 2j * 0.025 * rate)
    line = 0.05 * np.real(gain * np.exp(1j * 14.4 * ANGLE))
    assert np.ptp(line) > 1.5
    seen = turning(by_hand(line, ANGLE, rate=RATE, profile="reversal"), [order(14.4)], held=None)
    assert np.abs(seen.without_lines(seen.torque)[np.abs(seen.speed) > 30]).max() < 0.005


def test_projecting_twice_is_projecting_once(by_hand: ByHand) -> None:
    seen = turning(by_hand(friction(SPEED), ANGLE, rate=RATE, profile="reversal"), [order(1.0)], held=None)
    once = seen.without_lines(seen.torque)
    assert seen.without_lines(once) == pytest.approx(once, abs=1e-12)
    assert seen.lines.T @ seen.lines == pytest.approx(np.eye(seen.lines.shape[1]), abs=1e-12)


def test_only_a_run_that_turns_back_is_seen_by_blocks(by_hand: ByHand) -> None:
    back = by_hand(friction(SPEED), ANGLE, rate=RATE, profile="reversal")
    forth = by_hand(friction(SPEED), 60.0 * TIME, rate=RATE)
    assert turns_back(back)
    assert not turns_back(forth)
    assert features(forth, []).turning is None
    seen, held = features(back, []).turning, features(back, [], held=True).turning
    assert seen is not None
    assert held is not None
    # every third stretch is held out, and no block is seen in both
    assert held.speed.size == pytest.approx(seen.speed.size / 2, rel=0.2)
    assert not set(_samples(seen)) & set(_samples(held))


def _samples(blocks: Turning) -> list[int]:
    return [int(at) for start in blocks.start for at in range(start, start + blocks.length)]


def test_a_simulation_of_the_same_rig_turns_like_it(wear_rig: Scenario, record: Callable[..., Recording]) -> None:
    """Lines of another phase are projected out of both, and with them no part of the friction that the shaft turns."""
    rig = wear_rig.rig
    made = record(rig, 5, rpm=700.0, occupancy=5.0, profile="reversal")
    angle = made.channels["encoder_count"].in_si()
    run = observed(made, ShaftAngle(angle, "encoder", True), ratio=5.0)
    places = [order(at) for at in (0.2, 0.4, 0.6, 0.8, 1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 12.0, 14.0, 18.0, 21.0)]
    seen = features(run, places)
    twin = expected(rig, seen)
    (model,) = expected_by_simulation(rig, [seen], seeds=(7, 8))
    by_twin, by_simulation = (float(np.mean(misfit(seen, one).turning ** 2)) for one in (twin, model))
    # two copies have half the chance of one recording again
    assert by_simulation < 2.0 * max(by_twin, 0.5)
