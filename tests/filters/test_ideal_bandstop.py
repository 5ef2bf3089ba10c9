"""The reference report's filter: what is on a bin goes, what is off the bands stays to the last digits."""

from math import pi

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.filters.ideal_bandstop import IdealBandstop, without_bands
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

LINES = Kinematics(pole_pairs=7, slots=12, ratio=5).lines()


def test_lines_within_the_bands_go_and_everything_else_stays():
    rate, samples = 2500.0, 25000

    def wave(hertz, phase):
        # the phase is counted in whole samples, so that the sine itself is exact to some eps
        return np.sin(2 * pi * (round(hertz * 10) * np.arange(samples) % samples) / samples + phase)

    kept = 3.0 + wave(7, 0) + 0.3 * wave(98.4, 1) + 0.2 * wave(100.6, 2)
    cut = wave(99.5, 1) + wave(100, 3) + wave(100.5, 2)
    assert without_bands(kept + cut, rate, [(99.5, 100.5)]) == pytest.approx(kept, abs=1e-12)


def test_several_bands_at_once_equal_one_after_the_other():
    values = np.random.default_rng(1).normal(size=5000)
    bands = [(10.0, 11.0), (10.5, 13.0), (200.0, 201.0)]
    one_by_one = values
    for band in bands:
        one_by_one = without_bands(one_by_one, 1000.0, [band])
    assert without_bands(values, 1000.0, bands) == pytest.approx(one_by_one, abs=1e-13)


@pytest.mark.parametrize("samples", [9973, 10000, 10001])
def test_any_length_keeps_length_and_mean(samples):
    values = np.random.default_rng(2).normal(5.0, 1.0, samples)
    answer = without_bands(values, 1000.0, [(0.0, 3.0), (499.0, 700.0)])
    assert answer.size == samples
    assert answer.mean() == pytest.approx(values.mean(), abs=1e-13)


def test_the_control_signal_of_the_report_keeps_all_but_its_bands():
    # reference report, 3.7: all frequencies from 0 to half the sample rate at one amplitude
    rng = np.random.default_rng(3)
    rate, samples = 2500.0, 25000
    spectrum = np.exp(2j * pi * rng.uniform(size=samples // 2 + 1))
    spectrum[[0, -1]] = 1.0
    control = np.fft.irfft(spectrum, n=samples)
    lines = tuple(line for line in LINES if line.frequency(1000 * pi / 30) < 1000)
    stage = IdealBandstop(lines=lines, half_width=0.5)
    torque = Channel(values=control, quantity="torque", unit="V")
    answer = stage.apply(
        Recording(sample_rate=rate, channels={"torque_V": torque}, run=Run(speed=1000 * pi / 30))
    ).torque()
    hertz = np.arange(samples // 2 + 1) * rate / samples
    inside = np.zeros(hertz.size, dtype=bool)
    for low, high in stage.bands(1000 * pi / 30):
        inside |= (hertz >= low - 1e-9) & (hertz <= high + 1e-9)
    left = np.abs(np.fft.rfft(answer))
    assert left[inside].max() < 1e-11
    assert left[~inside] == pytest.approx(1.0, abs=1e-11)
    assert 100 < inside.sum() < 400


def test_without_a_speed_the_bands_have_no_place():
    torque = Channel(values=np.zeros(100), quantity="torque", unit="V")
    with pytest.raises(RecordingError, match=r"states no motor speed.*speed_rpm"):
        IdealBandstop(lines=LINES).apply(Recording(sample_rate=100.0, channels={"torque_V": torque}))


def test_a_band_without_width_is_refused():
    with pytest.raises(InputError, match="removes nothing"):
        IdealBandstop(lines=LINES, half_width=0.0)
