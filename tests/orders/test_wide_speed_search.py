"""A speed far from the sheet's is found by the comb of orders, and none where there is no comb."""

import numpy as np
import pytest

from torquerig.orders.angle.wide_speed_search import wide_speed_search

RATE = 2000.0
TIME = np.arange(20_000) / RATE
TRUE = 104.0  # [rad/s]
ORDERS = [1.0, 2.0, 3.0, 6.0, 7.0, 12.0, 14.0, 18.0, 21.0]


def recording(seed, *, size):
    rng = np.random.default_rng(seed)
    waves = [size * rng.uniform(0.3, 1) * np.cos(order * TRUE * TIME + rng.uniform(0, 6)) for order in ORDERS]
    return np.sum(waves, axis=0) + rng.standard_normal(TIME.size)


@pytest.mark.parametrize("factor", [0.6, 0.77, 1.0, 1.3, 1.9])
def test_it_is_found_whatever_the_sheet_says(factor):
    found = wide_speed_search(recording(1, size=0.2), RATE, set_point=TRUE * factor, orders=ORDERS)
    assert found == pytest.approx(TRUE, rel=1e-3)


def test_a_shaft_that_turns_backward_keeps_its_sign():
    found = wide_speed_search(recording(1, size=0.2), RATE, set_point=-0.77 * TRUE, orders=ORDERS)
    assert found == pytest.approx(-TRUE, rel=1e-3)


@pytest.mark.parametrize("seed", range(8))
def test_noise_has_no_speed(seed):
    assert wide_speed_search(recording(seed, size=0.0), RATE, set_point=TRUE, orders=ORDERS) is None


def test_one_strong_line_is_no_comb():
    torque = recording(2, size=0.0) + 5 * np.cos(2 * np.pi * 50 * TIME)
    assert wide_speed_search(torque, RATE, set_point=TRUE, orders=ORDERS) is None


def test_beyond_half_and_twice_nothing_is_looked_for():
    assert wide_speed_search(recording(3, size=0.2), RATE, set_point=TRUE * 3, orders=ORDERS) is None
