"""The direction of a shaft whose tacho counts upwards either way."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.inference.motor_angle.tacho_direction import directed

RATE = 1000.0
TIME = np.arange(16_000) / RATE


def counted(speed):
    """Return the angle that a tacho shows."""
    return np.concatenate([[0.0], np.cumsum(np.abs(speed[:-1])) / RATE])


@pytest.mark.parametrize("late", [0.0, 0.1, 0.3])
def test_a_shaft_turns_back_where_it_is_slowest(late):
    set_point = 100 * np.sin(4 * np.pi * TIME / 16)
    speed = 100 * np.sin(4 * np.pi * (TIME - late) / 16) * (late < TIME)
    true = np.concatenate([[0.0], np.cumsum(speed[:-1]) / RATE])
    # a mean over 20 ms finds the turn to 10 ms, in which the shaft moves by 4 mrad
    assert np.abs(directed(counted(speed), set_point) - true).max() < 0.02


def test_a_shaft_that_turns_backwards_counts_downwards():
    speed = np.full(TIME.size, -50.0)
    assert directed(counted(speed), speed)[-1] == pytest.approx(-50.0 * TIME[-1])
