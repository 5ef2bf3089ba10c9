"""The speed from torque alone: its stated 95 % interval is true, and no speed is invented."""

from math import pi

import numpy as np
import pytest

from tests.orders.drawn_signals import drawn_signal
from torquerig.orders.angle.best_angle import best_motor_speed
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

TOLERANCE = 0.01
LINES = Kinematics(pole_pairs=7, slots=12, ratio=5).lines()


def stated(seeds, **limits):
    """Return whether each true speed is in its interval, all half-widths, and those with four or more strong lines."""
    inside, widths, strong = [], [], []
    for seed in seeds:
        drawn = drawn_signal(seed, **limits)
        found = best_motor_speed(drawn.recording, drawn.kinematics.lines())
        inside.append(abs(drawn.speed / found.value - 1) <= found.half_width)
        widths.append(found.half_width)
        if drawn.strong_lines >= 4:
            strong.append(found.half_width)
    return np.mean(inside), np.array(widths), np.array(strong)


@pytest.mark.long
def test_drawn_speeds_are_in_their_interval():
    share, widths, strong = stated(range(30), longest=8.0, fastest=8000.0)
    # of 30, four are outside with a probability of 6 % where 95 % are inside
    assert share >= 26 / 30
    assert np.median(strong) <= 5e-4
    assert np.all(widths <= TOLERANCE)
    assert np.mean(widths < TOLERANCE) > 0.5


@pytest.mark.full
def test_two_hundred_drawn_speeds_are_in_their_interval():
    share, _, strong = stated(range(5000, 5200))
    assert 0.91 <= share <= 0.99
    assert np.median(strong) <= 5e-4


def recording(lines, tones, *, rpm, rate, seconds, noise, seed=5, wander=0.0):
    """A motor at ``rpm``, with amplitudes of orders and of fixed frequencies."""
    at = np.arange(int(rate * seconds)) / rate
    angle = rpm * pi / 30 * (at + wander / (2 * pi * 0.3) * np.sin(2 * pi * 0.3 * at))
    torque = 2 + noise * np.random.default_rng(seed).normal(size=at.size)
    torque += sum(size * np.sin(order * angle) for order, size in lines.items())
    torque += sum(size * np.sin(2 * pi * hertz * at) for hertz, size in tones.items())
    channel = Channel(values=torque, quantity="torque", unit="N*m")
    return Recording(sample_rate=rate, channels={"t": channel}, run=Run(speed=rpm * pi / 30, gear_ratio=5))


def test_one_strong_line_does_not_invent_a_speed():
    found = best_motor_speed(recording({1: 0.5}, {}, rpm=1000, rate=5000.0, seconds=10, noise=0.005), LINES)
    assert found.value * 30 / pi == pytest.approx(1000, rel=1e-6)
    assert found.half_width == TOLERANCE
    assert "set-point alone" in found.origin


def test_hum_next_to_an_order_does_not_attract_the_speed():
    source = recording({1: 0.05, 2: 0.03, 4: 0.02}, {50: 0.04}, rpm=1010, rate=5000.0, seconds=20, noise=0.01)
    found = best_motor_speed(source, LINES)
    assert found.value * 30 / pi == pytest.approx(1010, rel=1e-5)
    assert found.half_width < 1e-5


def test_hum_and_its_harmonics_are_no_orders():
    # 50, 100, 150 and 200 Hz are orders 3, 6, 9 and 12 at 1000 rpm; the motor turns at 1004
    source = recording({}, dict.fromkeys((50.01, 100.02, 150.03, 200.04), 0.05), rpm=1004, rate=5000.0, seconds=10,
                       noise=0.01)  # fmt: skip
    assert best_motor_speed(source, LINES).half_width == TOLERANCE


def test_one_fixed_tone_does_not_invent_a_speed():
    for hertz in (99.3, 101.1, 117.0, 233.9):
        source = recording({}, {hertz: 0.5}, rpm=1000, rate=2000.0, seconds=10, noise=0.01)
        assert best_motor_speed(source, LINES).half_width == TOLERANCE


def test_a_drift_that_all_lines_confirm_is_in_the_angle_and_hum_is_none():
    lines = dict.fromkeys((1, 2, 6, 7, 12, 14), 0.05)
    drifts = recording(lines, {}, rpm=1000, rate=2000.0, seconds=20, noise=0.005, wander=5e-4)
    assert "drift" in best_motor_speed(drifts, LINES).origin or "over time" in best_motor_speed(drifts, LINES).origin
    beats = recording({1: 0.05, 6: 0.05, 14: 0.02}, {100.6: 0.03}, rpm=1000, rate=2000.0, seconds=20, noise=0.005)
    found = best_motor_speed(beats, LINES)
    assert found.value * 30 / pi == pytest.approx(1000, rel=1e-5)
    assert found.half_width < 1e-5
