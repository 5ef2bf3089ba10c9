"""Angles that start again after a turn or an overflow are unwrapped, whatever their unit."""

from math import pi

import numpy as np
import pytest

from torquerig.recordings.channel_angle import angle_of, unsmoothed_angle_of, wrap_of
from torquerig.recordings.recording import Channel

RATE = 2000.0
AT = np.arange(16_000) / RATE
TRUE = 2 * pi * 1000 / 60 * AT + 1.0
# unit -> radians per unit
UNITS = {"deg": pi / 180, "rad": 1.0, "rev": 2 * pi}


def channel(values, unit, si_per_unit):
    return Channel(values=values, quantity="motor_angle", unit=unit, si_per_unit=si_per_unit)


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("lowest", [0.0, -0.5])  # 0 to 360 deg, -180 to 180 deg
@pytest.mark.parametrize("direction", [1, -1])
def test_an_angle_that_starts_again_each_turn_is_unwrapped(unit, lowest, direction):
    turns = direction * TRUE / (2 * pi)
    one_turn = 2 * pi / UNITS[unit]
    wrapped = channel(((turns - lowest) % 1.0 + lowest) * one_turn, unit, UNITS[unit])
    assert wrap_of(wrapped) == pytest.approx(one_turn)
    angle = angle_of(wrapped, RATE)
    assert angle - angle[0] == pytest.approx(direction * (TRUE - TRUE[0]), abs=1e-9)


@pytest.mark.parametrize(("stated", "modulus"), [(1024, 1024), (1024, 4096), (4096, 1024), (1000, 4000), (1024, 2**16)])
def test_a_counter_may_overflow_at_another_count_than_a_turn(stated, modulus):
    counts = np.floor(TRUE / (2 * pi) * 4000)
    wrapped = channel(counts % modulus, "count", 2 * pi / stated)
    assert wrap_of(wrapped) == modulus
    assert unsmoothed_angle_of(wrapped) * stated / (2 * pi) - (counts % modulus)[0] == pytest.approx(counts - counts[0])


@pytest.mark.parametrize("unit", UNITS)
def test_an_angle_that_does_not_start_again_stays(unit):
    for turned in (TRUE, 0.3 * np.sin(2 * pi * AT), np.where(AT < 4, 0.0, 2.0)):
        whole = channel(turned / UNITS[unit], unit, UNITS[unit])
        assert wrap_of(whole) is None
        assert unsmoothed_angle_of(whole) == pytest.approx(turned)
