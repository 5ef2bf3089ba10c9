"""Quotients made of several knobs at once, beside those of each knob alone."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.fitting.difference_quotients import quotients


def scattered(seed: int) -> np.ndarray:
    """Return a matrix of 8 knobs with 5 residuals of their own each, and 2 knobs that touch all residuals."""
    rng = np.random.default_rng(seed)
    own = np.kron(np.eye(8), np.ones((5, 1))) * rng.uniform(1.0, 4.0, (40, 8))
    return np.hstack([own, rng.uniform(0.5, 1.0, (40, 2))])


@pytest.mark.parametrize("seed", range(3))
def test_knobs_that_share_nothing_are_stepped_together(seed: int) -> None:
    matrix, asked = scattered(seed), list[np.ndarray]()

    def residuals(x: np.ndarray) -> np.ndarray:
        asked.append(x)
        return matrix @ x + 0.1 * (matrix @ x) ** 2

    here = np.random.default_rng(seed).standard_normal(10)
    found = residuals(here)
    told = quotients(residuals, here, found, known=3.0 * matrix)
    assert len(asked) == 1 + 3  # the eight at once, and the two
    np.testing.assert_allclose(told, (1 + 0.2 * (matrix @ here))[:, None] * matrix, rtol=2e-4, atol=1e-4)


def test_without_knowledge_each_knob_is_stepped_alone() -> None:
    matrix, here = scattered(5), np.zeros(10)
    told = quotients(lambda x: matrix @ x, here, matrix @ here, known=np.zeros((40, 0)))
    np.testing.assert_allclose(told, matrix, atol=1e-8)


def test_known_quotients_are_kept_and_only_new_knobs_are_stepped() -> None:
    matrix, here = scattered(6), np.zeros(10)
    told = quotients(lambda x: matrix @ x, here, matrix @ here, known=2.0 * matrix[:, :9], kept=True)
    np.testing.assert_array_equal(told[:, :9], 2.0 * matrix[:, :9])
    np.testing.assert_allclose(told[:, 9], matrix[:, 9], atol=1e-8)


def test_a_trace_that_two_knobs_share_goes_to_the_one_that_rules_it() -> None:
    matrix = np.array([[3.0, 0.02], [0.0, 2.0]])
    told = quotients(lambda x: 1.5 * (matrix @ x), np.zeros(2), np.zeros(2), known=matrix)
    assert told[0, 0] == pytest.approx(4.5, abs=0.02)
    assert told[0, 1] == 0.02  # as known
