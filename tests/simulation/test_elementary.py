"""Sine, exponential and hyperbolic tangent of the kernel, alone and in lanes, against 80-bit arithmetic."""

from __future__ import annotations

import numpy as np
import pytest
from numba import njit
from numpy.typing import NDArray

from torquerig.simulation.kernel.elementary import exponential, hyperbolic_tangent, sine_cosine
from torquerig.simulation.kernel.fast import FAST, UNCOUNTED
from torquerig.simulation.kernel.lanes import LANES, in_lanes

Floats = NDArray[np.float64]


@njit(fastmath=FAST)
def _of_all(x, sine, cosine, power, tangent):  # type: ignore[no-untyped-def]
    for i in range(x.size):
        sine[i], cosine[i] = sine_cosine(x[i])
        power[i], tangent[i] = exponential(x[i]), hyperbolic_tangent(x[i])


@njit(fastmath=FAST, **UNCOUNTED)
def _of_lanes(x, sine, cosine, power, tangent):  # type: ignore[no-untyped-def]
    _of_all(in_lanes(x), in_lanes(sine), in_lanes(cosine), in_lanes(power), in_lanes(tangent))


def made(x: Floats) -> Floats:
    """Return sine, cosine, exp and tanh; those in lanes must be the same."""
    alone, together = np.empty((4, x.size)), np.empty((4, x.size // LANES, LANES))
    _of_all(x, *alone)
    _of_lanes(x.reshape(-1, LANES), *together)
    assert np.all(np.abs(together.reshape(4, -1) - alone) <= 4e-16 * np.maximum(1.0, np.abs(alone)))
    return alone


@pytest.mark.long
@pytest.mark.parametrize("reach", [1e-3, 1.0, 30.0, 1e4, 1e6])
def test_sine_and_cosine_are_right_to_3e16(reach: float) -> None:
    x = np.random.default_rng(1).uniform(-reach, reach, 40_000)
    exact = x.astype(np.longdouble)
    sine, cosine, *_ = made(x)
    assert np.abs(sine - np.sin(exact)).max() < 3e-16
    assert np.abs(cosine - np.cos(exact)).max() < 3e-16


@pytest.mark.parametrize("reach", [1e-6, 0.1, 1.0, 20.0])
def test_exponential_and_tangent_are_right_to_3e16_of_their_value(reach: float) -> None:
    x = np.random.default_rng(2).uniform(-reach, reach, 40_000)
    exact = x.astype(np.longdouble)
    *_, power, tangent = made(x)
    assert np.abs(power / np.exp(exact) - 1).max() < 3e-16
    assert np.abs(tangent / np.tanh(exact) - 1).max() < 3e-16


def test_far_powers_end_where_they_must() -> None:
    *_, power, tangent = made(np.array([-700.0, -800.0, -1e6, 0.0, 1.0, 1e6, 700.0, -40.0]))
    assert power[:3] == pytest.approx(np.exp(-700.0), rel=1e-13)
    assert power[5:7] == pytest.approx(np.exp(700.0), rel=1e-13)
    assert power[3] == 1.0
    assert tangent[[2, 3, 5, 7]].tolist() == [-1.0, 0.0, 1.0, -1.0]
