"""A simulated run whose angle is blurred as the recording's is, or left as it is."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np

from torquerig.diagnosis.looking.as_well_known import as_well_known
from torquerig.diagnosis.looking.observed import Observed

RATE = 5000.0
TIME = np.arange(int(6 * RATE)) / RATE
SLOW = 30.0 * TIME + 2.0 * np.sin(2 * pi * 0.15 * TIME)  # as a set-point or a wander moves it
RIPPLE = 0.05 * np.sin(2 * pi * 5.0 * TIME)  # as one turn of a shaft does


def made(by_hand: Callable[..., Observed], angle: np.ndarray, *, measured: bool) -> Observed:
    return by_hand(np.zeros(TIME.size), angle, rate=RATE, measured=measured)


def test_ripple_of_the_speed_is_lost_and_its_slow_course_kept(by_hand: Callable[..., Observed]) -> None:
    copy, recorded = (made(by_hand, SLOW + RIPPLE, measured=measured) for measured in (True, False))
    blurred = as_well_known(copy, recorded)
    middle = (TIME > 1.0) & (TIME < 5.0)
    assert np.abs(blurred.angle - SLOW)[middle].max() < 0.1 * 0.05
    assert not blurred.angle_measured
    assert np.ptp(blurred.speed[middle] - np.gradient(SLOW, TIME)[middle]) < 0.1


def test_an_angle_that_was_measured_stays(by_hand: Callable[..., Observed]) -> None:
    copy, recorded = (made(by_hand, SLOW + RIPPLE, measured=True) for _ in range(2))
    assert as_well_known(copy, recorded) is copy
