"""Laws of the lapped transform, and of the likelihood of its coefficients."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.motion.density import log_density
from torquerig.inference.motion.lapped import frequencies, from_lapped, lapped


@pytest.mark.parametrize("bins", [16, 33, 200])
def test_the_transform_is_a_rotation(bins: int) -> None:
    values = np.random.default_rng(1).standard_normal(12 * bins)
    values[:bins] = values[-bins:] = 0.0  # the first and last half frames belong to no other
    coefficients = lapped(values, bins, band=0.5)
    assert float((coefficients**2).sum()) == pytest.approx(float((values**2).sum()), rel=1e-10)
    assert from_lapped(coefficients, bins, values.size) == pytest.approx(values, abs=1e-10)


def test_a_cosine_is_at_its_frequency() -> None:
    rate, bins = 100.0, 50
    time = np.arange(2000) / rate
    power = (lapped(np.cos(2 * np.pi * 7.3 * time), bins, band=0.1) ** 2).mean(axis=0)
    assert abs(frequencies(bins, band=0.1, rate=rate)[int(np.argmax(power))] - 7.3) < rate / (2 * bins)


def test_the_likelihood_is_largest_at_the_true_density() -> None:
    residual = 3.0 * np.random.default_rng(2).standard_t(8, size=20_000)
    values = [log_density(residual, np.asarray(s)) for s in (7.0, 9.0, 11.5)]
    assert max(values) == values[1]
