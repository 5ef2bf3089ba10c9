"""What leaks into a fast line from slow noise, against the spread that the line's amplitude really has."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.diagnosis.looking.leakage import leaked
from torquerig.inference.features.regression import regressed
from torquerig.inference.features.waves import Waves
from torquerig.inference.places import frequency

RATE, COUNT, AT = 5000.0, 2500, 600.0
TIME = np.arange(COUNT) / RATE


def spread_and_told(pole: float, noise: float, draws: int = 200) -> tuple[float, float]:
    """Mean square of the real part of a line's amplitude where there is none, and what the density says of it."""
    rng = np.random.default_rng(1)
    squares, told = [], []
    for _ in range(draws):
        slow = lfilter([1.0], [1.0, -2 * pole, pole**2], rng.standard_normal(4 * COUNT))[-COUNT:]
        values = slow / (1 / (1 - pole) ** 2) + noise * rng.standard_normal(COUNT)
        found = regressed(values, Waves([frequency(AT)], np.zeros(COUNT), TIME))
        squares.append(float(np.abs(found.amplitude[0]) ** 2) / 2)
        told.append(float(leaked(found.rest, RATE, [(AT, AT)])[0]) / (COUNT / RATE))
    return float(np.mean(squares)), float(np.mean(told))


def test_steep_slow_noise_makes_a_fast_line_uncertain_by_so_much() -> None:
    square, told = spread_and_told(pole=0.98, noise=1e-6)
    assert told == pytest.approx(square, rel=0.25)


def test_of_white_noise_nothing_leaks() -> None:
    assert spread_and_told(pole=0.0, noise=1.0, draws=20)[1] == 0.0


def test_no_line_is_no_density() -> None:
    assert leaked(np.zeros(100), RATE, []).size == 0
