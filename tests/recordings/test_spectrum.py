"""Amplitude spectra against sines of known amplitude."""

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.spectrum import amplitude_spectrum, band_amplitude, hann_spectrum

RATE = 1000.0


def wave(hertz, samples=2000):
    return 0.7 * np.sin(2 * np.pi * hertz * np.arange(samples) / RATE + 0.3)


@pytest.mark.parametrize("samples", [2000, 2001])
def test_a_sine_on_a_bin_shows_its_amplitude_there_alone(samples):
    at = 100 * RATE / samples
    frequency, amplitude = amplitude_spectrum(1.5 + wave(at, samples), RATE)
    expected = np.zeros(samples // 2 + 1)
    expected[0], expected[100] = 1.5, 0.7
    assert amplitude == pytest.approx(expected, abs=1e-12)
    assert frequency[100] == pytest.approx(at)


def test_a_hann_window_shows_the_same_with_halves_beside_it():
    _, amplitude = hann_spectrum(-1.5 + wave(50.0), RATE)
    assert amplitude[[0, 98, 99, 100, 101, 102]] == pytest.approx([1.5, 0, 0.35, 0.7, 0.35, 0], abs=1e-12)


@pytest.mark.parametrize(("spectrum", "share"), [(amplitude_spectrum, 2 / np.pi), (hann_spectrum, 8 / (3 * np.pi))])
def test_between_two_bins_a_sine_shows_its_scalloping_loss(spectrum, share):
    # Harris 1978, table 1: 3.92 dB and 1.42 dB
    _, amplitude = spectrum(wave(50.25), RATE)
    assert amplitude[[100, 101]] == pytest.approx(0.7 * share, rel=0.01)


def test_half_the_sample_rate_shows_its_amplitude():
    _, amplitude = amplitude_spectrum(np.tile([1.0, -1.0], 500), RATE)
    assert amplitude[-1] == pytest.approx(1.0)


def test_the_power_in_a_band_is_one_sine():
    values = wave(50.0) + wave(50.5)
    complex_amplitude = np.fft.rfft(values) * 2 / values.size
    assert band_amplitude(complex_amplitude, 0.5, 50.0, 50.5) == pytest.approx(0.7 * np.sqrt(2))
    assert band_amplitude(complex_amplitude, 0.5, 51.0, 60.0) == pytest.approx(0.0, abs=1e-12)


def test_one_sample_has_no_spectrum():
    with pytest.raises(RecordingError, match="no spectrum"):
        amplitude_spectrum(np.zeros(1), RATE)
