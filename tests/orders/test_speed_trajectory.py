"""The course of the speed from the torque alone: wander of per cents, and the penalty's banded matrix."""

from math import pi

import numpy as np
import pytest

from torquerig.filters.order_bandstop import OrderBandstop
from torquerig.orders.angle.second_differences import second_difference_bands, times_bands
from torquerig.orders.angle.speed_from_torque import motor_angle_from_torque
from torquerig.orders.angle.speed_trajectory import speed_trajectory
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
AT = np.arange(100_000) / RATE
SPEED = 1000 * pi / 30
LINES = tuple(line for line in Kinematics(pole_pairs=7, slots=12, ratio=5).lines() if line.motor_order < 90)
ORDERS = np.array(sorted({round(line.motor_order, 9) for line in LINES}))


def wandering(share):
    relative = 1 + share * np.sin(2 * pi * 0.1 * AT)
    angle = np.cumsum(SPEED * relative) / RATE
    rng = np.random.default_rng(3)
    lines = sum(0.5 * np.cos(order * angle + rng.uniform(0, 2 * pi)) for order in ORDERS)
    load = 1.0 + 0.1 * rng.normal(size=AT.size)
    return relative, angle, lines, load


def recording(torque):
    channel = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=SPEED, gear_ratio=5))


def test_a_course_of_two_per_cent_is_found_to_a_thousandth():
    relative, _, lines, load = wandering(0.02)
    course = speed_trajectory(load + lines, SPEED * AT, ORDERS, rate=RATE)
    assert np.std((course - relative)[5000:-5000]) < 1e-3


@pytest.mark.long
@pytest.mark.parametrize(
    ("share", "wanted"), [(0.02, -25), pytest.param(0.002, -40, marks=pytest.mark.full), (0.0002, -45)]
)
def test_lines_fall_by_the_torque_alone(share, wanted):
    # fixed notches reach 8 dB at 2 %; with an encoder the same band-stop reaches 54 dB
    _, angle, lines, load = wandering(share)
    source = recording(load + lines)
    found = motor_angle_from_torque(source, LINES).values - angle
    assert np.std(found) < 3e-3
    left = OrderBandstop(lines=LINES).apply(source).torque() - load
    assert 20 * np.log10(np.std(left) / np.std(lines)) < wanted


def test_a_run_of_few_turns_has_no_course():
    assert speed_trajectory(np.zeros(5000), SPEED * AT[:5000], ORDERS, rate=RATE) is None


def test_the_bands_are_those_of_second_differences():
    second = np.diff(np.eye(9), n=2, axis=0)
    full = second.T @ second
    bands = second_difference_bands(9)
    for away in range(3):
        assert bands[2 - away, away:] == pytest.approx(np.diag(full, away))
    values = np.random.default_rng(1).normal(size=9)
    assert times_bands(bands, values) == pytest.approx(full @ values)
