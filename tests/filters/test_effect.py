"""What a chain did: spread, mean, energy and line levels against closed forms."""

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.filters.chains.filter_chain import report_filter_code_chain
from torquerig.filters.filter_effect import chain_effect
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

KINEMATICS = Kinematics(pole_pairs=7, slots=12, ratio=5)
RATE = 2500.0
AT = np.arange(25000) / RATE
SPEED = 600 * pi / 30  # 10 Hz: every line on a bin


def recording(torque, **run):
    channel = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(**{"speed": SPEED} | run))


def test_a_removed_line_shows_in_every_figure():
    torque = 2.0 + 0.3 * np.sin(2 * pi * 60 * AT) + 0.4 * np.sin(2 * pi * 37.3 * AT)
    before = recording(torque)
    chain = report_filter_code_chain(KINEMATICS)
    effect = chain_effect(before, chain.apply(before), ratio=5, lines=chain.lines)
    assert effect.std_before == pytest.approx(sqrt((0.09 + 0.16) / 2), rel=1e-9)
    assert effect.std_after == pytest.approx(sqrt(0.16 / 2), rel=1e-9)
    assert effect.std_reduction_percent == pytest.approx(20.0, rel=1e-9)
    assert effect.variance_reduction_percent == pytest.approx(36.0, rel=1e-9)
    assert effect.mean_change_percent == pytest.approx(0.0, abs=1e-12)
    levels = effect.family_levels()
    assert levels["cogging_per_pole"] == pytest.approx((0.3, 0.0), abs=1e-12)
    assert levels["electrical"] == pytest.approx((0.0, 0.0), abs=1e-12)


def test_energy_is_torque_times_output_speed_over_time():
    before, after = recording(np.full(AT.size, 2.0)), recording(np.full(AT.size, 1.5))
    effect = chain_effect(before, after, ratio=5)
    assert effect.energy_before == pytest.approx(2.0 * SPEED / 5 * AT[-1])
    assert effect.energy_change_percent == pytest.approx(-25.0)
    assert "set-point" in effect.speed_origin


def test_energy_takes_a_measured_speed_first():
    speed = Channel(values=np.full(AT.size, 0.99 * SPEED), quantity="motor_speed", unit="rad/s")
    before = recording(np.full(AT.size, 2.0)).with_channel("motor_speed", speed)
    effect = chain_effect(before, before, ratio=5)
    assert effect.energy_before == pytest.approx(2.0 * 0.99 * SPEED / 5 * AT[-1])
    assert effect.speed_origin == "from the channel motor_speed"


def test_without_any_speed_there_is_no_energy_and_no_line():
    before = recording(np.sin(AT), speed=None)
    effect = chain_effect(before, before, ratio=5, lines=KINEMATICS.lines())
    assert effect.energy_before is None
    assert effect.energy_change_percent is None
    assert effect.levels == ()


def test_a_ramp_has_energy_by_its_profile_and_no_levels():
    before = recording(np.ones(AT.size), profile="ramp")
    effect = chain_effect(before, before, ratio=1, lines=KINEMATICS.lines())
    # mean of the profile: 0.9 of the time from 0.1 to 1, then 1: 0.9 * 0.55 + 0.1
    assert effect.energy_before == pytest.approx(0.595 * SPEED * 10, rel=1e-3)
    assert effect.levels == ()


def test_recordings_of_different_length_cannot_be_compared():
    with pytest.raises(RecordingError, match="cannot be compared"):
        chain_effect(recording(np.zeros(5)), recording(np.zeros(6)), ratio=5)
    with pytest.raises(RecordingError, match="cannot be compared"):
        chain_effect(recording(np.zeros(1)), recording(np.zeros(1)), ratio=5)
