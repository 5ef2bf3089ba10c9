"""Spikes and dropouts are found where they were put, and nowhere in honest signals."""

import numpy as np
import pytest

from torquerig.recordings.inspection.outliers import dropouts_in, spikes_in

RATE = 25_000.0


def torque(seed: int = 3) -> np.ndarray:
    """Return a torque as a sensor of 1 kHz reads it: noise through a low-pass, lines, quantized."""
    rng = np.random.default_rng(seed)
    smooth = np.convolve(rng.standard_normal(50_000), np.hanning(40) / 20, mode="same")
    time = np.arange(50_000) / RATE
    values = 1 + 0.2 * smooth + 0.1 * np.sin(2 * np.pi * 117 * time) + 1e-4 * rng.standard_normal(50_000)
    return np.round(values / 3e-4) * 3e-4


def ringing() -> np.ndarray:
    """Return impacts that ring at 3 kHz, thirty times as high as the rest."""
    values = torque()
    ring = np.exp(-np.arange(300) / 40) * np.sin(2 * np.pi * 3000 * np.arange(300) / RATE)
    for start in range(1000, 49_000, 1370):
        values[start : start + 300] += 0.5 * ring
    return values


HONEST = {
    "torque": torque(),
    "ringing impacts": ringing(),
    "white noise": np.random.default_rng(5).standard_normal(50_000),
    "a square wave": np.sign(np.sin(2 * np.pi * 3 * np.arange(50_000) / RATE)),
    "a staircase": np.floor(np.arange(50_000) / 700.0),
    "a sine": np.sin(2 * np.pi * 50 * np.arange(50_000) / RATE),
}


@pytest.mark.parametrize("name", HONEST)
def test_honest_signals_have_none(name: str) -> None:
    assert spikes_in(HONEST[name]) == []
    assert dropouts_in(HONEST[name], longest=2500) == []


@pytest.mark.parametrize("height", [0.5, -3.0])
def test_spikes_are_found_where_they_are(height: float) -> None:
    values, places = torque(), [500, 20_000, 20_010, 49_000]
    values[places] += height
    assert spikes_in(values) == places


def test_a_spike_of_two_samples_is_one() -> None:
    values = torque()
    values[[700, 701]] += [1.0, 1.1]
    assert len(spikes_in(values)) == 1
    assert spikes_in(values)[0] in (700, 701)


@pytest.mark.parametrize("noise", [0.0, 1e-4])
@pytest.mark.parametrize("level", [0.0, 5.0])
def test_dropouts_are_found_with_their_length_and_level(noise: float, level: float) -> None:
    values = torque()
    rng = np.random.default_rng(1)
    for first, length in ((4000, 75), (30_000, 500)):
        values[first : first + length] = level + noise * rng.standard_normal(length)
    found = dropouts_in(values, longest=2500)
    assert [(run.first, run.length) for run in found] == [(4000, 75), (30_000, 500)]
    assert [run.value for run in found] == pytest.approx([level, level], abs=1e-4)


def test_what_lasts_longer_is_a_level_of_the_signal() -> None:
    values = torque()
    values[10_000:14_000] = 0.0
    assert dropouts_in(values, longest=2500) == []


@pytest.mark.parametrize("every", [3, 4, 10])
def test_held_samples_are_no_dropouts_and_hide_none(every: int) -> None:
    values = np.random.default_rng(3).standard_normal(20_000)[np.arange(20_000) // every * every]
    assert dropouts_in(values, longest=500) == []
    values[7000:7100] = -40.0
    (found,) = dropouts_in(values, longest=500)
    assert (found.first, found.length, found.value) == (7000, 100, -40.0)
