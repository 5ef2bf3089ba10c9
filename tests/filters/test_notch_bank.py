"""The notch bank: the closed form of its gain, the delay that it states, and what it refuses."""

from math import pi

import numpy as np
import pytest
from scipy.signal import group_delay, iirnotch, sos2tf

from torquerig.errors import InputError, RecordingError
from torquerig.filters.notch_bank import CausalNotchBank, NotchBank, notches
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE = 5000.0
SPEED = 1000 * pi / 30
LINES = tuple(line for line in Kinematics(pole_pairs=7, slots=12, ratio=5).lines(2) if line.motor_order < 90)
AT = np.arange(100_000) / RATE


def recording(torque, speed=SPEED, **channels):
    torque = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": torque, **channels}, run=Run(speed=speed))


def measured_speed(value):
    return Channel(values=np.full(AT.size, value), quantity="motor_speed", unit="rad/s")


def test_a_notch_is_scipys():
    section = notches(LINES[2:3], SPEED, 0.5, RATE)[0]
    centre = LINES[2].frequency(SPEED)
    assert section == pytest.approx(np.concatenate(iirnotch(centre, centre / 1.0, RATE)), rel=1e-12)


def test_lines_go_at_the_measured_speed_and_the_mean_stays():
    real = 1.005 * SPEED
    lines = sum(np.cos(2 * pi * line.frequency(real) * AT) for line in LINES)
    source = recording(2.0 + lines, speed=SPEED, speed_rad_s=measured_speed(real))
    left = NotchBank(lines=LINES).apply(source).torque() - 2.0
    # 120 dB down before the sum of the notches' roundings; equal ends make no difference
    assert np.std(left) < 1e-3 * np.std(lines)


def test_the_stated_delay_is_that_of_slow_load():
    stage = CausalNotchBank(lines=LINES, half_width=0.5)
    sections = notches(LINES, SPEED, 0.5, RATE)
    by_scipy = sum(group_delay(sos2tf(row[None]), w=[1e-5], fs=2 * pi)[1][0] for row in sections)
    assert stage.delay(recording(AT)) == pytest.approx(by_scipy / RATE, rel=1e-4)
    # a slow ramp comes late by so much once the notches have rung in
    assert (AT - stage.apply(recording(AT)).torque())[-1] == pytest.approx(stage.delay(recording(AT)), rel=1e-6)


def test_a_causal_bank_does_not_know_the_future():
    values = np.random.default_rng(3).normal(size=AT.size)
    later = values.copy()
    later[5000:] = 0.0
    stage = CausalNotchBank(lines=LINES)
    assert np.array_equal(stage.apply(recording(values)).torque()[:5000], stage.apply(recording(later)).torque()[:5000])


def test_lines_beyond_the_rate_have_no_notch():
    assert len(notches(LINES, SPEED * 40, 0.5, RATE)) < len({line.motor_order for line in LINES})


def test_what_cannot_be_is_refused():
    with pytest.raises(InputError, match="remove nothing"):
        NotchBank(lines=LINES, half_width=0.0)
    with pytest.raises(RecordingError, match="too few for"):
        NotchBank(lines=LINES).apply(recording(AT[:50], speed_rad_s=measured_speed(SPEED)))
    with pytest.raises(RecordingError, match="states no motor speed"):
        CausalNotchBank(lines=LINES).apply(recording(AT, speed=None))
