"""How the values of a reading are spread: the number of jumps is a count, and its chance that of counts."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.looking.value_features import of_values, value_misfit


def _counted(jumps: float | np.ndarray) -> np.ndarray:
    return 2 * np.sqrt(np.asarray(jumps) + 0.375)


def _values(jumps: float) -> np.ndarray:
    return np.array([0.0, 0.0, float(_counted(jumps))])


@pytest.mark.parametrize("mean", [2.0, 8.0])
def test_a_count_is_missed_by_its_chance_and_no_more(mean: float) -> None:
    rng = np.random.default_rng(1)
    drawn = _counted(rng.poisson(mean, (3, 4000)))
    missed = [
        value_misfit(np.array([0, 0, one]), np.array([0, 0, (a + b) / 2]))[2] for one, a, b in drawn.T
    ]  # a recording beside two simulations
    assert np.std(missed) == pytest.approx(1.0, abs=0.12)


def test_what_is_there_ten_times_is_missed_clearly() -> None:
    assert abs(value_misfit(_values(30), _values(3))[2]) > 4


def test_shares_are_missed_by_their_own_spreads() -> None:
    missed = value_misfit(np.array([0.5, 0.1, 1.2]), np.array([0.1, 0.0, 1.2]))
    assert missed == pytest.approx([0.4 / np.hypot(0.01, 0.075), 0.1 / np.hypot(2e-3, 0.015), 0.0])


def test_a_reading_that_stands_at_its_limit_jumps_no_more_often_than_the_torque() -> None:
    rng = np.random.default_rng(2)
    slow = np.convolve(rng.standard_normal(60_000), np.ones(40) / 40, mode="same")
    torque = slow + 1e-3 * rng.standard_normal(60_000)
    torque[3000::6000] -= 4.0  # ten lost samples, there and back
    volts = np.minimum(torque, np.quantile(torque, 0.4))
    _, on_end, counted = of_values(volts)
    assert on_end == pytest.approx(0.6, abs=0.01)
    assert counted == pytest.approx(of_values(torque)[2], abs=2.0)


@pytest.mark.parametrize("first", [1.0, -1.0])
def test_steps_of_one_coarse_code_are_no_jumps(first: float) -> None:
    """There are as many up as down but for one, and of the two the median is whichever has that one more."""
    rng = np.random.default_rng(3)
    steps = np.zeros(4001)
    steps[::10] = rng.permutation(np.concatenate([np.full(201, first), np.full(200, -first)]))
    volts = 0.075 * np.concatenate([[0.0], np.cumsum(steps)])
    assert of_values(volts)[2] == pytest.approx(_counted(0.0))
