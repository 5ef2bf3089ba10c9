"""What a line that sweeps within a block leaves in the bands."""

from __future__ import annotations

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.features.run_features import run_features
from torquerig.inference.places import order
from torquerig.inference.prediction.line_features import free_of_lines, swept_below

RATE, DURATION = 1000.0, 2.0  # [Hz], [s]


@pytest.mark.parametrize(("slow", "fast"), [(100.0, 160.0), (100.0, 110.0), (120.0, 120.0)])
def test_a_swept_line_has_the_spectrum_of_a_windowed_sweep(slow, fast):
    time = np.arange(int(RATE * DURATION)) / RATE
    wave = np.cos(2 * np.pi * (slow * time + 0.5 * (fast - slow) * time**2 / DURATION))
    power = np.abs(np.fft.rfft(wave * np.hanning(wave.size))) ** 2
    below = np.append(0.0, np.cumsum(power)) / power.sum()
    frequency = (np.arange(below.size) - 0.5) / DURATION
    edges = np.linspace(slow - 3.0, fast + 3.0, 12)
    expected = swept_below(edges, slow=np.array(slow), fast=np.array(fast), width=np.array(1.5 / DURATION))
    # an even distribution over the sweep is off by 0.13 a quarter of the way
    assert expected == pytest.approx(np.interp(edges, frequency, below), abs=0.03)


def test_a_block_shows_hardly_anything_of_the_ends_of_a_sweep():
    ends = swept_below(np.array([106.0, 154.0]), slow=np.array(100.0), fast=np.array(160.0), width=np.array(0.75))
    assert ends[0] < 1e-3
    assert 1 - ends[1] < 1e-3


def test_the_bins_of_a_line_are_in_no_band():
    seen = run_features(drawn_run(1, speed=steady(1000), orders={6.0: 0.3}), [order(6.0)])
    cuts, free = free_of_lines(seen, 0)
    middle, at, reach = 0.5 * (cuts[1:] + cuts[:-1]), 100.0, seen.line_excluded[0, 0]
    assert ((free.sum(axis=1) == 0) == (np.abs(middle - at) < reach)).all()
    # an even density stays what it is
    assert np.diff(cuts) @ free == pytest.approx(1.0)
