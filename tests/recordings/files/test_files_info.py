"""What `recording_info` tells: figures against closed forms, and suspicions only where there is reason."""

import numpy as np
import pytest

from torquerig.recordings.inspection.recording_info import longest_run, recording_info
from torquerig.recordings.recording import Channel, Recording

RATE, COUNT = 10_000.0, 20_000


def info_of(values: np.ndarray, quantity: str = "torque"):
    channel = Channel(values=values, quantity=quantity, unit="V", si_per_unit=2.0)
    return recording_info(Recording(sample_rate=RATE, channels={"x": channel}, name="run1.csv"))


def noise() -> np.ndarray:
    return np.random.default_rng(3).standard_normal(COUNT)


def test_figures_of_a_sine() -> None:
    info = info_of(1.5 + 2 * np.sin(2 * np.pi * 50 * np.arange(COUNT) / RATE))
    one = info["x"]
    assert (info.samples, info.duration, info.sample_rate) == (COUNT, 2.0, RATE)
    assert one.mean == pytest.approx(1.5, abs=1e-12)
    assert one.std == pytest.approx(2 / np.sqrt(2), rel=1e-12)
    assert (one.minimum, one.maximum) == pytest.approx((-0.5, 3.5), abs=1e-12)
    assert info.suspicions() == []
    assert info.as_dict()["channels"]["x"]["maximum"] == one.maximum


@pytest.mark.parametrize("step", [None, 0.01, 0.5])
def test_noise_from_an_honest_converter_is_not_suspicious(step: float | None) -> None:
    values = noise() if step is None else step * np.round(noise() / step)
    assert info_of(values).suspicions() == []


@pytest.mark.parametrize("step", [0.5, 0.1, 0.01])
def test_a_sine_rests_on_its_extremes_unclipped(step: float) -> None:
    # the top level of a sampled sine is sqrt(s) wide, the next one sqrt(3 s) - sqrt(s): 1.37 times as often, not twice
    values = step * np.round(np.sin(2 * np.pi * 49.3 * np.arange(COUNT) / RATE) / step)
    assert info_of(values)["x"].longest_repeat > 3
    assert info_of(values).suspicions() == []


@pytest.mark.parametrize("step", [None, 0.01])
def test_clipping_is_counted_on_the_side_where_it_is(step: float | None) -> None:
    values = noise() if step is None else step * np.round(noise() / step)
    values = np.convolve(values, np.ones(8) / 8, mode="same")
    limit = 0.4
    info = info_of(np.minimum(values, limit))
    assert info["x"].clipped_high == np.count_nonzero(values >= limit)
    assert info["x"].clipped_low == 0
    assert "x looks clipped at 0.4 V" in info.suspicions()[0]


def test_constant_signal() -> None:
    info = info_of(np.full(COUNT, 0.7))
    assert info["x"].constant
    assert info.suspicions() == [f"x is constant at 0.7 V in all its {COUNT} samples; is the sensor connected?"]


def test_a_stuck_stretch_is_placed() -> None:
    values = noise()
    values[5000:5030] = values[5000]
    info = info_of(values)
    assert (info["x"].longest_repeat, info["x"].repeat_from) == (30, 5000)
    assert info.suspicions() == ["x holds one value for 30 samples (0.003 s) from sample 5000 (0.5 s) on"]


def test_a_resting_encoder_is_not_suspicious() -> None:
    assert info_of(np.maximum(0.0, np.arange(COUNT) - 9000.0), "motor_angle").suspicions() == []


def test_longest_run_by_hand() -> None:
    assert longest_run(np.array([1.0, 1, 2, 2, 2, 3])) == (3, 2)
    assert longest_run(np.array([1.0, 2, 3])) == (1, 0)
    assert longest_run(np.array([4.0, 4])) == (2, 0)
