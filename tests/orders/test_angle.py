"""The motor's angle from encoder, output angle and speed channels."""

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.orders.angle.measured_angle import MotorAngle, measured_motor_angle
from torquerig.recordings.recording import Channel, Recording
from torquerig.sensor_stages.encoder import Encoder

RATE = 5000.0
AT = np.arange(20000) / RATE
TRUE = 100.0 * AT + 0.5 * np.sin(2 * np.pi * 0.7 * AT)


def recording(**channels):
    torque = Channel(values=np.zeros(AT.size), quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": torque, **channels})


def encoded(counts_per_rev, true=TRUE):
    truth = Channel(values=true, quantity="motor_angle", unit="rad", truth=True)
    return Encoder(counts_per_rev=counts_per_rev).apply(recording(true_motor_angle_rad=truth)).without_truth()


@pytest.mark.parametrize("counts_per_rev", [400, 16384])
def test_encoder_angle_is_true_to_a_count_and_smoother_than_it(counts_per_rev):
    count = 2 * np.pi / counts_per_rev
    error = measured_motor_angle(encoded(counts_per_rev)).values - (TRUE - count / 2)
    assert np.abs(error).max() < count
    assert error.std() < count / np.sqrt(12)


@pytest.mark.parametrize("modulus", [1024, 2**16])
def test_a_counter_that_starts_again_is_unwrapped(modulus):
    source = encoded(1024)
    counts = source.channels["encoder_count"].values
    wrapped = source.with_values("encoder_count", counts % modulus)
    whole = measured_motor_angle(source).values
    assert measured_motor_angle(wrapped).values - whole == pytest.approx(np.zeros(AT.size), abs=1e-9)


def test_a_reversal_is_no_overflow():
    true = 3.0 * np.sin(2 * np.pi * AT)
    error = measured_motor_angle(encoded(1024, true)).values - true
    assert np.abs(error).max() < 0.02  # a count is 0.006 rad, the curve within 2 ms bends by less


def test_output_channels_are_counted_in_motor_turns():
    output = Channel(values=TRUE / 5, quantity="angle", unit="rad")
    assert measured_motor_angle(recording(a=output), ratio=5).values == pytest.approx(TRUE)
    speed = Channel(values=np.gradient(TRUE / 5, 1 / RATE), quantity="speed", unit="rad/s")
    turned = measured_motor_angle(recording(s=speed), ratio=5)
    assert turned.values == pytest.approx(TRUE - TRUE[0], abs=1e-3)
    assert turned.origin == "from the channel s"


def test_truth_is_never_taken_for_a_measurement():
    truth = Channel(values=TRUE, quantity="motor_angle", unit="rad", truth=True)
    assert measured_motor_angle(recording(true_motor_angle_rad=truth)) is None


def test_mean_speed_needs_two_samples():
    assert MotorAngle(np.array([0.0, 0.1, 0.2]), "").mean_speed(100.0) == pytest.approx(10.0)
    with pytest.raises(RecordingError, match="two samples"):
        MotorAngle(np.array([0.0]), "").mean_speed(100.0)
