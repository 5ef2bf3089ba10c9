"""The load taken back through a known response: a mode's ringing goes, noise stays out, a detuned model is retuned."""

from math import pi

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.errors import InputError, RecordingError
from torquerig.filters.load_inverse import LoadInverse, fitted_spectra
from torquerig.filters.load_response import LoadResponse
from torquerig.recordings.recording import Channel, Recording

RATE, SAMPLES, NOISE = 5000.0, 100_000, 0.003
GRID = np.geomspace(0.05, 2500, 6000)
MODE, DAMPING = 130.0, 0.03


def mode(frequencies, at=MODE):
    ratio = frequencies / at
    return 1 / (1 - ratio**2 + 2j * DAMPING * ratio)


def rung(load, rng):
    spectrum = np.fft.rfft(load) * mode(np.fft.rfftfreq(load.size, 1 / RATE))
    return np.fft.irfft(spectrum, n=load.size) + NOISE * rng.normal(size=load.size)


@pytest.fixture(scope="module")
def run():
    """A load with a mean and a corner of 40 Hz, and what a sensor behind a mode reads of it."""
    rng = np.random.default_rng(1)
    pole = np.exp(-2 * pi * 40 / RATE)
    hits = lfilter([np.sqrt(1 - pole**2)], [1, -pole], rng.normal(size=SAMPLES))
    load = 2.0 + 0.2 * hits
    return load, recording(rung(load, rng))


def recording(torque):
    channel = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel})


def rms(values):
    return float(np.sqrt(np.mean(values**2)))


def test_ringing_goes_and_the_mean_stays(run):
    load, source = run
    stage = LoadInverse(response=LoadResponse(GRID, mode(GRID)), retune=0.0)
    answer = stage.apply(source).torque()
    assert rms(answer - load) < 0.3 * rms(source.torque() - load)
    assert answer.mean() == pytest.approx(load.mean(), abs=1e-3)


def test_spectra_are_found(run):
    load, source = run
    found = fitted_spectra(source.torque(), RATE, LoadResponse(GRID, mode(GRID)), retune=0.0)
    # 20 s: some 40 averaged periodograms over 500 bins below 250 Hz
    assert found.corner == pytest.approx(40.0, rel=0.1)
    assert found.noise == pytest.approx(NOISE**2 / (RATE / 2), rel=0.1)
    assert found.level * found.corner * pi / 2 == pytest.approx(np.var(load), rel=0.15)


@pytest.mark.parametrize("wrong", [0.9, 1.1])
def test_a_model_that_is_ten_per_cent_off_is_retuned(run, wrong):
    load, source = run
    detuned = LoadResponse(GRID, mode(GRID, MODE * wrong))
    trusted = LoadInverse(response=detuned, retune=0.0).apply(source).torque()
    retuned = LoadInverse(response=detuned, retune=0.15).apply(source).torque()
    right = LoadInverse(response=LoadResponse(GRID, mode(GRID)), retune=0.0).apply(source).torque()
    assert fitted_spectra(source.torque(), RATE, detuned, retune=0.15).stretch == pytest.approx(1 / wrong, abs=0.01)
    assert rms(retuned - load) < 1.05 * rms(right - load)
    assert rms(trusted - load) > 1.3 * rms(right - load)
    # even trusted, it is nearer to the load than the reading
    assert rms(trusted - load) < rms(source.torque() - load)


def test_a_response_of_one_leaves_load_above_the_noise_alone():
    rng = np.random.default_rng(2)
    pole = np.exp(-2 * pi * 40 / RATE)
    load = 1.0 + lfilter([1], [1, -pole], rng.normal(size=SAMPLES))
    ones = LoadResponse(GRID, np.ones(GRID.size, dtype=complex))
    answer = LoadInverse(response=ones, retune=0.0).apply(recording(load)).torque()
    assert rms(answer - load) < 0.05 * np.std(load)


def test_what_cannot_be_is_refused(run):
    response = LoadResponse(GRID, mode(GRID))
    with pytest.raises(InputError, match="cannot be retuned"):
        LoadInverse(response=response, retune=0.7)
    with pytest.raises(InputError, match="rising frequencies"):
        LoadResponse(GRID[::-1], mode(GRID))
    with pytest.raises(RecordingError, match="too few to separate load and noise"):
        LoadInverse(response=response).apply(recording(np.zeros(1000)))
