"""Angle and speed channels that contradict the set-point or each other are named, with the likely reason."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.orders.angle.speed_contradictions import speed_contradictions
from torquerig.orders.angle.suspicions import angle_sentences
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, RPM = 2000.0, 1000.0
AT = np.arange(8000) / RATE
TURNS = RPM / 60 * 1.004 * AT


def recording(rpm=RPM, profile="steady", **channels):
    torque = Channel(values=np.zeros(AT.size), quantity="torque", unit="N*m")
    speed = None if rpm is None else rpm * pi / 30
    run = Run(speed=speed, gear_ratio=5.0, profile=profile)
    return Recording(sample_rate=RATE, channels={"t": torque, **channels}, run=run)


def counts(per_turn, stated, quantity="motor_angle"):
    return Channel(values=np.floor(TURNS * per_turn), quantity=quantity, unit="count", si_per_unit=2 * pi / stated)


def speed(rpm, unit="rpm", quantity="motor_speed"):
    per_unit = {"rpm": pi / 30, "rad/s": 1.0}[unit]
    return Channel(values=np.full(AT.size, rpm), quantity=quantity, unit=unit, si_per_unit=per_unit)


def test_channels_that_agree_are_not_named():
    assert (
        speed_contradictions(recording(enc=counts(1024, 1024), n=speed(1004.0), out=speed(200.8, quantity="speed")))
        == ()
    )
    assert angle_sentences(recording(enc=counts(1024, 1024))) == []
    assert speed_contradictions(recording(profile="reversal", n=speed(20.0))) == ()


@pytest.mark.parametrize(("times", "per_turn"), [(4.0, "4096"), (2.0, "2048"), (0.5, "512"), (0.25, "256")])
def test_wrong_counts_per_turn_are_named(times, per_turn):
    (sentence,) = speed_contradictions(recording(enc=counts(1024 * times, 1024)))
    assert f"{times * 1.004:.4g} times the set-point" in sentence
    assert sentence.endswith(f"{per_turn} counts per turn?")


@pytest.mark.parametrize(
    ("channel", "reason"),
    [
        (speed(200.8), "of the output shaft?"),
        (speed(1004.0, quantity="speed"), "of the motor shaft?"),
        (speed(1004.0, unit="rad/s"), "is it in rpm?"),
        (speed(105.1), "is it in rad/s?"),
        (speed(1037.0), "check speed_rpm and the channel's scale"),
        (speed(333.0), "check its unit, its counts per turn and speed_rpm"),
    ],
)
def test_the_other_shaft_and_wrong_units_are_named(channel, reason):
    (sentence,) = speed_contradictions(recording(n=channel))
    assert reason in sentence
    assert "\n" not in sentence


def test_a_wrong_sample_rate_is_named():
    slow = replace(recording(enc=counts(1024, 1024)), sample_rate=0.96 * RATE)
    (sentence,) = speed_contradictions(slow)
    assert sentence.endswith("check sample_rate_Hz and speed_rpm")


def test_without_a_set_point_channels_are_compared_with_each_other():
    (sentence,) = speed_contradictions(recording(rpm=None, enc=counts(4096, 1024), n=speed(1004.0)))
    assert "enc: 4096 counts per turn?" in sentence
    assert speed_contradictions(recording(rpm=None, enc=counts(1024, 1024), n=speed(1004.0))) == ()


def test_lost_counts_are_named():
    broken = counts(1024, 1024)
    values = broken.values - 700.0 * (np.arange(AT.size) >= 4000)
    (sentence,) = angle_sentences(recording(enc=replace(broken, values=values)))
    assert "enc jumps 1 times, first at 1.9995 s" in sentence


@pytest.mark.parametrize(("rate", "is_named"), [(20.0, True), (60.0, True), (1000.0, False)])
def test_an_angle_with_few_samples_a_turn_is_named(rate, is_named):
    turned = 1002 / 60 * np.arange(400) / rate
    angle = Channel(values=360 * turned % 360, quantity="motor_angle", unit="deg", si_per_unit=np.pi / 180)
    torque = Channel(values=np.ones(400), quantity="torque", unit="N*m")
    found = speed_contradictions(Recording(sample_rate=rate, channels={"torque": torque, "enc": angle}))
    assert any("samples a turn" in sentence for sentence in found) is is_named
