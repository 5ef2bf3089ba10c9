"""What a torque moves the shaft by within each turn, found from the side lines that it gives to all others."""

import numpy as np

from torquerig.orders.angle.periodic_angle_error import periodic_angle_error

RATE, SECONDS = 5000.0, 8.0
TIME = np.arange(int(RATE * SECONDS)) / RATE
EVEN = 2 * np.pi * 16.61 * TIME
ORDERS = np.array([0.2, 0.4, 1.0, 2.0, 6.0, 7.0, 12.0, 14.0, 18.0, 21.0, 28.0])
FLOOR = np.full(ORDERS.size, 1e-6)


def lines(angle, rng):
    waves = [0.05 * rng.uniform(0.3, 1) * np.cos(n * angle + rng.uniform(0, 6)) for n in ORDERS if n > 2.5]
    return np.sum(waves, axis=0) + 1e-3 * rng.standard_normal(angle.size)


def test_a_speed_ripple_is_found_to_a_fiftieth():
    strays = 0.02 * np.cos(0.2 * EVEN + 1.0) + 0.004 * np.cos(1.0 * EVEN - 0.5)
    torque = lines(EVEN + strays, np.random.default_rng(1))
    found = periodic_angle_error(torque, EVEN, ORDERS, FLOOR)
    assert np.std(found - strays) < 0.02 * np.std(strays)


def test_an_even_speed_stays_even():
    found = periodic_angle_error(lines(EVEN, np.random.default_rng(2)), EVEN, ORDERS, FLOOR)
    assert np.abs(found).max() < 3e-4


def test_amplitude_modulation_of_one_line_is_no_ripple_of_the_speed():
    rng = np.random.default_rng(3)
    torque = lines(EVEN, rng) + 0.05 * 0.3 * np.cos(0.2 * EVEN) * np.cos(12 * EVEN + 1)
    assert np.abs(periodic_angle_error(torque, EVEN, ORDERS, FLOOR)).max() < 2e-3  # it alone would ask for 0.025


def test_without_lines_nothing_is_found():
    noise = 1e-3 * np.random.default_rng(4).standard_normal(EVEN.size)
    assert not periodic_angle_error(noise, EVEN, ORDERS, FLOOR).any()
