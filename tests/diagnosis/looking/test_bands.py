"""The spectrum in bands: a known density comes back within chance, and a line spoils only what stands beside it."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.bands import BANDS_PER_OCTAVE, band_edges, bands, no_bands, spectrum

RATE, SAMPLES, STRETCHES = 2000.0, 4000, 4
SIGMA = 0.2
WHITE = 2 * SIGMA**2 / RATE  # one-sided density of white noise


def noise(seed: int, count: int = STRETCHES) -> np.ndarray:
    return SIGMA * np.random.default_rng(seed).standard_normal((count, SAMPLES))


def test_white_noise_has_its_density_in_every_band() -> None:
    seen = bands([spectrum(rest, RATE, []) for rest in noise(1)], RATE)
    # 0.7: see `test_a_band_scatters...`; five sigma of some 60 bands
    assert np.all(np.abs(seen.power / WHITE - 1) < 5 / np.sqrt(0.7 * seen.count))


def test_the_densities_add_up_to_the_variance() -> None:
    """Parseval; bins below the lowest band and above the highest hold the rest."""
    seen = bands([spectrum(rest, RATE, []) for rest in noise(2)], RATE)
    share = seen.width.sum() / (RATE / 2)
    assert (seen.power * seen.width).sum() / SIGMA**2 == pytest.approx(share, rel=5 / np.sqrt(STRETCHES * SAMPLES / 2))


def test_a_band_scatters_about_as_its_count_says() -> None:
    """Neighbouring bins under a Hann window correlate by 4/9 in power: 0.51 of many are independent, 1 of one is."""
    draws = [bands([spectrum(rest, RATE, []) for rest in noise(seed)], RATE) for seed in range(10, 110)]
    scatter = np.std([each.power / WHITE for each in draws], axis=0) * np.sqrt(draws[0].count)
    # 100 draws: a standard deviation is known to 7 %; sqrt(0.7 / 0.51) = 1.17 for wide bands, sqrt(0.7) for single bins
    assert np.all((scatter > 0.84 - 0.28) & (scatter < 1.17 + 0.35))


def test_a_line_that_was_asked_for_leaves_its_band_alone() -> None:
    time, at, amplitude = np.arange(SAMPLES) / RATE, 123.4, 0.5
    tone = amplitude * np.cos(2 * pi * at * time)
    beside = bands([spectrum(rest, RATE, []) for rest in noise(3)], RATE)
    known = bands([spectrum(rest + tone, RATE, [at]) for rest in noise(3)], RATE)
    unknown = bands([spectrum(rest + tone, RATE, []) for rest in noise(3)], RATE)
    band = int(np.argmin(np.abs(np.log(known.middle / at))))
    # what of the tone lies beyond the four bins that are left out is a millionth of it
    assert known.power[band] == pytest.approx(beside.power[band], rel=0.3)
    assert known.count[band] < beside.count[band]
    added = (unknown.power - beside.power)[band - 1 : band + 2] * known.width[band - 1 : band + 2]
    assert added.sum() == pytest.approx(amplitude**2 / 2, rel=0.05)
    far = np.abs(np.arange(known.power.size) - band) > 1
    assert unknown.power[far] == pytest.approx(beside.power[far], rel=0.05)


def test_a_band_that_lines_fill_is_not_a_number() -> None:
    at = 10.0
    lines = [at + step * RATE / SAMPLES for step in range(-8, 9)]
    seen = bands([spectrum(rest, RATE, lines) for rest in noise(4)], RATE)
    empty = ~np.isfinite(seen.power)
    assert empty.any()
    # the lines reach from 6 to 14 Hz, and two bins of 0.5 Hz either way
    assert np.all((seen.middle[empty] > 4.99) & (seen.middle[empty] < 15.01))
    assert np.all(seen.count[empty] < 1)


def test_edges_stand_eight_to_the_octave_and_stay_below_half_the_rate() -> None:
    edges = band_edges(RATE)
    assert np.diff(np.log2(edges)) == pytest.approx(1 / BANDS_PER_OCTAVE)
    assert edges[-1] < 0.5 * RATE
    assert edges[-1] * 2 ** (1 / BANDS_PER_OCTAVE) > 0.45 * RATE


def test_a_run_that_moves_has_places_and_no_densities() -> None:
    empty = no_bands(RATE)
    assert empty.power.size == 0
    assert np.all(np.diff(empty.middle) > 0)


def test_bands_around_a_notch_are_as_narrow_as_it_is() -> None:
    """Each holds two bins of 2 s or three hundredths of its frequency; white noise has its density in all of them."""
    for at in (25.0, 80.0):
        edges = band_edges(RATE, (at,))
        assert np.all(np.diff(edges) > 0)
        near = np.diff(edges)[(edges[:-1] > 0.9 * at) & (edges[1:] < 1.1 * at)]
        assert near == pytest.approx(np.full(near.size, max(1.0, 0.03 * at)))
        far = np.abs(edges / at - 1) > 0.3
        assert set(edges[far]) <= set(band_edges(RATE))
        seen = bands([spectrum(rest, RATE, []) for rest in noise(4)], RATE, (at,))
        assert seen.power.size > bands([spectrum(rest, RATE, []) for rest in noise(4)], RATE).power.size
        assert np.all(np.abs(seen.power / WHITE - 1) < 5 / np.sqrt(0.7 * seen.count))
