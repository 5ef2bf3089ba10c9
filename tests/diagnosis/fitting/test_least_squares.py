"""The fit of the knobs beside scipy's: the same minimum, within the same limits, in fewer evaluations."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import least_squares

from torquerig.diagnosis.fitting.least_squares import minimum, robust_square, weights

LIMIT = 5.0


def bent(seed: int) -> Callable[[np.ndarray], np.ndarray]:
    rng = np.random.default_rng(seed)
    matrix, wanted = rng.standard_normal((60, 12)), 3 * rng.standard_normal(60)
    return lambda x: np.tanh(0.3 * (matrix @ x)) * 8 - wanted


@pytest.mark.parametrize("seed", range(4))
def test_the_minimum_is_scipys(seed: int) -> None:
    residuals, start = bent(seed), np.zeros(12)
    found = minimum(residuals, start, limit=LIMIT, derivatives=20)
    peer = least_squares(lambda x: np.concatenate([residuals(x), x]), start, bounds=(-LIMIT, LIMIT))
    assert found.cost <= 2 * peer.cost * (1 + 2e-3)
    assert np.abs(found.positions).max() <= LIMIT


def test_the_jacobian_at_the_minimum_is_that_of_the_residuals() -> None:
    matrix = np.random.default_rng(1).standard_normal((30, 5))
    found = minimum(lambda x: matrix @ x - 1.0, np.zeros(5), limit=LIMIT, derivatives=3)
    np.testing.assert_allclose(found.jacobian, matrix, atol=1e-6)
    np.testing.assert_allclose(found.positions, np.linalg.solve(matrix.T @ matrix + np.eye(5), matrix.sum(axis=0)))


def test_a_knob_that_wants_beyond_its_limit_stops_there_and_the_others_go_on() -> None:
    wanted = np.array([100.0, 1.0])
    found = minimum(lambda x: 10 * (x - wanted), np.zeros(2), limit=LIMIT, derivatives=5)
    np.testing.assert_allclose(found.positions, [LIMIT, 100 / 101], rtol=1e-6)


def test_a_known_jacobian_saves_evaluations_and_changes_no_minimum() -> None:
    residuals, count = bent(7), [0]

    def counted(x: np.ndarray) -> np.ndarray:
        count[0] += 1
        return residuals(x)

    afresh = minimum(counted, np.zeros(12), limit=LIMIT, derivatives=20)
    first, count[0] = count[0], 0
    again = minimum(counted, afresh.positions, limit=LIMIT, derivatives=20, jacobian=afresh.jacobian[:, :10])
    assert count[0] < 0.7 * first
    assert again.cost == pytest.approx(afresh.cost, rel=3e-3)


@pytest.mark.parametrize("seed", range(4))
def test_with_outliers_the_minimum_is_that_of_the_robust_squares(seed: int) -> None:
    """One residual in six is a hundred spreads off: scipy minimises the roots of the robust squares."""
    rng, bend = np.random.default_rng(seed), 4.0
    matrix, wanted = rng.standard_normal((60, 8)), rng.standard_normal(60)
    wanted[::6] += 100 * rng.standard_normal(10)

    def residuals(x: np.ndarray) -> np.ndarray:
        return matrix @ x + 0.1 * (matrix @ x) ** 2 - wanted

    found = minimum(residuals, np.zeros(8), limit=LIMIT, derivatives=20, bend=bend)
    peer = least_squares(
        lambda x: np.concatenate([np.sqrt(robust_square(residuals(x), bend)), x]), np.zeros(8), bounds=(-LIMIT, LIMIT)
    )
    assert found.cost <= 2 * peer.cost * (1 + 2e-3)


def test_a_robust_square_is_a_square_for_small_residuals_and_grows_in_proportion_to_large_ones() -> None:
    np.testing.assert_allclose(robust_square(np.array([0.01, -0.01]), 4.0), 1e-4, rtol=1e-5)
    far = robust_square(np.array([1e5, 2e5]), 4.0)
    assert far[1] / far[0] == pytest.approx(2.0, rel=1e-3)
    at, step = np.array([3.0]), 1e-6
    slope = (robust_square(at + step, 4.0) - robust_square(at - step, 4.0)) / (2 * step)
    np.testing.assert_allclose(weights(at, 4.0), slope / (2 * at), rtol=1e-6)


@pytest.mark.parametrize("seed", range(3))
def test_many_outliers_of_a_linear_model_cost_no_further_derivatives(seed: int) -> None:
    """Its derivatives hold everywhere, so steps that are reweighted for where they lead need one set of them."""
    rng, count = np.random.default_rng(seed), [0]
    matrix, wanted = rng.standard_normal((60, 8)), rng.standard_normal(60)
    wanted[::3] += 100 * rng.standard_normal(20)

    def residuals(x: np.ndarray) -> np.ndarray:
        count[0] += 1
        return matrix @ x - wanted

    found = minimum(residuals, np.zeros(8), limit=LIMIT, derivatives=1, bend=4.0)
    assert count[0] <= 1 + 8 + 2
    peer = least_squares(
        lambda x: np.concatenate([np.sqrt(robust_square(residuals(x), 4.0)), x]),
        np.zeros(8), bounds=(-LIMIT, LIMIT), xtol=1e-14, ftol=1e-14, gtol=1e-14,
    )  # fmt: skip
    assert found.cost <= 2 * peer.cost * (1 + 2e-5)
