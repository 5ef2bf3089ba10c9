"""Noise, converter and encoder: their statistics, bounds and repeatability."""

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.recording import Channel, Recording
from torquerig.sensor_stages.converter import Converter
from torquerig.sensor_stages.encoder import Encoder
from torquerig.sensor_stages.noise import WhiteNoise


def recording(values, seed=7, **channels):
    torque = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V")
    return Recording(sample_rate=25000.0, channels={"torque_V": torque, **channels}, origin={"seed": seed})


def volts(result):
    return result.channels["torque_V"].values


def test_noise_has_its_rms_and_no_colour():
    noise = volts(WhiteNoise(rms=0.005).apply(recording(np.zeros(100_000))))
    # 100 000 samples know their rms to 0.22 % (one sigma), their correlation to 0.32 %: five sigma each
    assert noise.std() == pytest.approx(0.005, rel=0.012)
    assert abs(np.mean(noise[1:] * noise[:-1])) < 0.016 * 0.005**2


def test_noise_is_the_same_for_the_same_seed_and_another_for_another():
    stage = WhiteNoise(rms=0.1)
    again = [volts(stage.apply(recording(np.ones(100), seed=seed))) for seed in (1, 1, 2)]
    assert np.array_equal(again[0], again[1])
    assert not np.array_equal(again[0], again[2])


def test_zero_noise_changes_nothing():
    source = recording([1.0, 2.0])
    assert np.array_equal(volts(WhiteNoise(rms=0.0).apply(source)), [1.0, 2.0])


def test_converter_errs_by_half_a_step_at_most_and_by_step_over_root_12_rms():
    # Widrow & Kollar: a signal over many codes
    converter = Converter(range_V=10.0, bits=12)
    source = np.linspace(-9.0, 9.0, 200_003)
    error = volts(converter.apply(recording(source))) - source
    assert np.abs(error).max() <= 0.5 * converter.step * (1 + 1e-12)
    assert error.std() == pytest.approx(converter.step / np.sqrt(12), rel=1e-3)


def test_converter_of_16_bit_and_10_volts_has_the_handbook_noise():
    # handbook 6.8: 0.09 mV rms
    assert Converter(range_V=10.0, bits=16).step / np.sqrt(12) == pytest.approx(0.09e-3, rel=0.03)


def test_converter_is_mid_tread_and_clips_at_its_last_codes():
    converter = Converter(range_V=1.0, bits=3)
    assert converter.step == 0.25
    answer = volts(converter.apply(recording([-5.0, -0.13, 0.0, 0.12, 0.13, 5.0])))
    assert np.array_equal(answer, [-1.0, -0.25, 0.0, 0.0, 0.25, 0.75])


def test_converting_twice_changes_nothing():
    converter = Converter(range_V=10.0, bits=16)
    once = converter.apply(recording(np.random.default_rng(0).normal(size=1000)))
    assert np.array_equal(volts(converter.apply(once)), volts(once))


def test_encoder_counts_whole_steps_passed_in_either_direction():
    angle = Channel(
        values=np.array([0.0, 0.49, 0.51, 1.0, -0.01]) * 2 * np.pi, quantity="motor_angle", unit="rad", truth=True
    )
    result = Encoder(counts_per_rev=4).apply(recording(np.zeros(5), true_motor_angle_rad=angle))
    assert np.array_equal(result.channels["encoder_count"].values, [0, 1, 2, 4, -1])
    assert result.find("motor_angle") == "encoder_count"
    below = result.channels["true_motor_angle_rad"].values - result.channels["encoder_count"].in_si()
    assert below.min() >= -1e-12
    assert below.max() < 2 * np.pi / 4


def test_an_encoder_without_an_angle_says_so():
    with pytest.raises(RecordingError, match="true_motor_angle_rad"):
        Encoder(counts_per_rev=1024).apply(recording(np.zeros(5)))


@pytest.mark.parametrize(
    "make",
    [
        lambda: WhiteNoise(rms=-1.0),
        lambda: Converter(range_V=0.0, bits=16),
        lambda: Converter(range_V=10.0, bits=0),
        lambda: Encoder(counts_per_rev=0),
    ],
)
def test_stages_that_cannot_be_are_refused(make):
    with pytest.raises(InputError, match="cannot be"):
        make()
