"""Bands, delay, hits, inserted steps: each against a closed form."""

from dataclasses import dataclass
from math import pi

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.filters.evaluation.bands import band_rms, bands_below
from torquerig.filters.evaluation.delay import delay_behind
from torquerig.filters.evaluation.hits import hit_response, hits_of
from torquerig.filters.evaluation.rise import rise_time
from torquerig.filters.evaluation.step_response import step_response
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.recordings.recording import Channel, Recording

RATE = 5000.0


def recording(values, unit=1.0):
    channel = Channel(values=np.asarray(values, dtype=float), quantity="torque", unit="V", si_per_unit=unit)
    return Recording(sample_rate=RATE, channels={"torque_V": channel})


@dataclass(frozen=True)
class Late:
    """Comes so many samples later."""

    samples: int

    def apply(self, given):
        name = given.torque_name()
        values = given.channels[name].values
        return given.with_values(name, np.concatenate([np.full(self.samples, values[0]), values])[: values.size])


@pytest.mark.parametrize("samples", [4096, 4095])
def test_the_bands_add_up_to_the_mean_square(samples):
    values = 0.3 + np.random.default_rng(1).normal(size=samples)
    parts = band_rms(values, RATE, bands_below(RATE))
    assert np.sqrt((parts**2).sum()) == pytest.approx(np.sqrt(np.mean(values**2)), rel=1e-12)


def test_a_sine_stands_in_its_own_band_alone():
    time = np.arange(5000) / RATE
    parts = band_rms(0.5 * np.sin(2 * pi * 20 * time) + 1.5, RATE, bands_below(RATE))
    by_band = dict(zip(bands_below(RATE), parts, strict=True))
    assert by_band[10, 50] == pytest.approx(0.5 / np.sqrt(2), rel=1e-9)
    assert by_band[0, 1] == pytest.approx(1.5, rel=1e-9)
    assert by_band[50, 100] < 1e-9


def test_the_bands_end_at_half_the_sample_rate():
    assert bands_below(120.0) == ((0, 1), (1, 10), (10, 50), (50, 60))


@pytest.mark.parametrize("late", [-17, 0, 40])
def test_a_delay_is_found_to_a_tenth_of_a_sample(late):
    noise = np.random.default_rng(2).normal(size=9000)
    smooth = np.convolve(noise, np.hanning(31), mode="same")
    found = delay_behind(smooth[1000 - late : 8000 - late], smooth[1000:8000], rate=RATE)
    assert found.seconds * RATE == pytest.approx(late, abs=0.1)
    assert found.correlation == pytest.approx(1.0, abs=0.01)


def test_a_constant_has_no_delay():
    assert delay_behind(np.ones(100), np.arange(100.0), rate=RATE) is None
    with pytest.raises(RecordingError, match="give two signals of one run"):
        delay_behind(np.ones(100), np.ones(99), rate=RATE)


def test_a_ramp_rises_from_a_tenth_to_nine_tenths_in_eight_tenths_of_its_length():
    ramp = np.clip((np.arange(400) - 100) / 100, 0, 1)
    assert rise_time(ramp, RATE) == pytest.approx(80 / RATE, rel=1e-9)
    assert rise_time(np.zeros(10), RATE) == 0.0


def hits(seconds=4.0, count=20):
    load = np.full(int(seconds * RATE), 1.0)
    for begin in np.linspace(0.1, seconds - 0.1, count):
        time = np.arange(load.size) / RATE - begin
        load += np.where(time >= 0, 0.4 * np.exp(-np.maximum(time, 0) / 4e-3), 0.0)
    return load


def test_hits_are_found_where_they_are():
    found = hits_of(hits(), RATE)
    assert found.size == 20
    assert found / RATE == pytest.approx(np.linspace(0.1, 3.9, 20), abs=2.2e-3)
    assert hits_of(np.ones(5000), RATE).size == 0


def test_a_reading_of_half_the_height_shows_half_the_peak():
    load = hits()
    shown = hit_response(0.5 * load + 3.0, load, rate=RATE)
    assert shown.count == 20
    assert shown.height == pytest.approx(0.4, rel=0.02)
    assert (shown.peak, shown.peak_low, shown.peak_high) == pytest.approx((0.5, 0.5, 0.5), abs=0.01)
    assert shown.rise == pytest.approx(shown.true_rise, abs=1 / RATE)


def test_a_late_reading_keeps_its_peak_when_its_delay_is_known():
    load = hits()
    late = np.concatenate([np.full(50, load[0]), load])[: load.size]
    assert hit_response(late, load, rate=RATE, delay=50 / RATE).peak == pytest.approx(1.0, abs=0.02)


def test_a_mean_over_samples_stretches_a_step_by_its_window():
    # the answer is a ramp as long as the window
    rng = np.random.default_rng(3)
    window = 101
    shown = step_response(MovingMeanKept(samples=window, around=(Zero(),)), recording(rng.normal(size=4000)))
    assert shown.rise == pytest.approx(0.8 * window / RATE, rel=0.02)
    assert shown.late == pytest.approx(0.0, abs=2 / RATE)
    assert shown.overshoot == pytest.approx(0.0, abs=1e-9)
    assert shown.pre_ringing == pytest.approx(0.5, abs=0.02)
    # a mean over many decays holds decay / window of the hit
    assert shown.hit_peak == pytest.approx(4e-3 * RATE * (1 - np.exp(-window / RATE / 4e-3)) / window, rel=0.05)


@dataclass(frozen=True)
class Zero:
    """Leaves nothing."""

    def apply(self, given):
        name = given.torque_name()
        return given.with_values(name, np.zeros_like(given.channels[name].values))


def test_what_changes_nothing_keeps_step_and_hit():
    shown = step_response(Late(0), recording(np.random.default_rng(4).normal(size=4000), unit=2.0))
    assert (shown.overshoot, shown.pre_ringing, shown.late) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert shown.rise <= 1 / RATE
    assert shown.hit_peak == pytest.approx(1.0)


def test_a_delay_shows_as_late():
    shown = step_response(Late(60), recording(np.random.default_rng(5).normal(size=4000)))
    assert shown.late == pytest.approx(60 / RATE)
    assert shown.pre_ringing == pytest.approx(0.0, abs=1e-12)


def test_a_constant_torque_gives_no_measure():
    with pytest.raises(RecordingError, match="torque is constant"):
        step_response(Late(0), recording(np.ones(100)))
