"""Gradient and Hessian of the likelihood where standard deviations depend on the parameters."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.likelihood import log_density_of
from torquerig.inference.slopes import after_step, gradient_of, hessian_of, stacked

GENERATOR = np.random.default_rng(5)
RATES, WIDER = GENERATOR.normal(size=(40, 3)), GENERATOR.normal(size=(40, 3)) * 0.4
BASE, SD = GENERATOR.normal(size=40), np.exp(GENERATOR.normal(size=40))


def at(position):
    """Return standardised residuals and standard deviations of a model that is linear in its parameters."""
    sd = SD * np.exp(WIDER @ position)
    return (SD * BASE + SD * (RATES @ position)) / sd, sd


def columns():
    return np.stack([stacked(*column) for column in zip(RATES.T, WIDER.T, strict=True)], axis=1)


def test_the_gradient_is_that_of_the_density():
    value, _ = at(np.zeros(3))
    steps = 1e-5 * np.eye(3)
    wanted = [(log_density_of(*at(-step)) - log_density_of(*at(step))) / 2e-5 for step in steps]
    assert gradient_of(columns(), value) == pytest.approx(np.array(wanted), rel=1e-6)


def test_the_hessian_is_the_expected_one():
    nu = 8.0
    value = np.random.default_rng(1).standard_t(nu, size=400_000)
    spread = stacked(np.zeros(value.size), np.ones(value.size))[:, None]
    scores = gradient_of(spread * np.eye(1), value) / value.size
    weighted = (1 - (nu + 1) * value**2 / (nu + value**2)) ** 2
    assert (hessian_of(spread, value)[0, 0] - 1) / value.size == pytest.approx(weighted.mean(), rel=0.01)
    assert scores == pytest.approx(0.0, abs=0.01), "expected score"


def test_a_step_changes_residuals_and_their_standard_deviations():
    step = np.array([0.3, -0.2, 0.1])
    value, sd = at(np.zeros(3))
    for found, wanted in zip(after_step(columns(), value, sd, step), at(step), strict=True):
        assert found == pytest.approx(wanted)
