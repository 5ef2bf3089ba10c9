"""Side lines that an uneven speed puts beside a line are no effects; larger ones are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.diagnosis.looking.lines_left import lines_left
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.diagnosis.looking.side_lines import without_side_lines
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario

RATE, SAMPLES = 4000.0, 48_000
EVEN = 2 * np.pi * 16.7 * np.arange(SAMPLES) / RATE
STRAYS = 0.02  # [rad] at order 0.2
ByHand = Callable[..., Observed]


def run(by_hand: ByHand, *, times: float) -> Observed:
    """Order 7 by an angle that was measured, and beside it ``times`` what its straying alone would give."""
    angle = EVEN + STRAYS * np.cos(0.2 * EVEN)
    side = times * 0.5 * 7 * STRAYS * 0.1
    noise = 2e-4 * np.random.default_rng(1).standard_normal(SAMPLES)
    return by_hand(noise + 0.1 * np.cos(7 * angle) + side * np.cos(7.2 * angle + 1), angle, rate=RATE, name="run1")


@pytest.mark.parametrize(("times", "kept"), [(0.5, 0), (1.1, 0), (3.0, 1)])
def test_what_the_straying_explains_is_no_line(times: float, kept: int, by_hand: ByHand, wear_rig: Scenario) -> None:
    peak = Peak(order(7.2), 400.0, ("run1",), 1)
    found = without_side_lines([peak], [run(by_hand, times=times)], [order(7.0)], rig=wear_rig.rig)
    assert len(found) == kept


def test_far_from_any_carrier_every_peak_stays(by_hand: ByHand, wear_rig: Scenario) -> None:
    peak = Peak(order(40.0), 30.0, ("run1",), 1)
    assert without_side_lines([peak], [run(by_hand, times=1.0)], [order(7.0)], rig=wear_rig.rig) == (peak,)


def test_the_lines_that_are_left_hold_no_side_line(by_hand: ByHand, wear_rig: Scenario) -> None:
    found = lines_left([run(by_hand, times=1.0)], [order(7.0)], rig=wear_rig.rig)
    assert not [peak for peak in found if abs(peak.place.at - 7) < 0.5]
