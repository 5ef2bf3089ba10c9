"""What is normal where another state takes nearly half of the time: the half that lies closest together."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.gain_changes import gain_moments
from torquerig.recordings.repair.short_spectra import by_median, closest_half
from torquerig.scenario.model import Scenario


def test_a_normal_variate_has_its_mean_and_spread() -> None:
    drawn = 3.0 + 0.5 * np.random.default_rng(1).standard_normal(20_000)
    for told in (closest_half(drawn), by_median(drawn)):
        assert told == pytest.approx((3.0, 0.5), abs=0.06)


def test_a_second_state_of_two_fifths_of_the_time_pulls_the_median_and_not_the_closest_half() -> None:
    drawn = 0.05 * np.random.default_rng(1).standard_normal(10_000)
    drawn[:4000] -= 1.0
    middle, spread = closest_half(drawn)
    assert middle == pytest.approx(0.0, abs=0.02)
    assert spread < 0.12 < 0.14 < by_median(drawn)[1]


def test_a_gain_that_is_elsewhere_for_two_fifths_of_a_run(wear_rig: Scenario, record: Callable[..., Recording]) -> None:
    clean = record(wear_rig.rig, 3, duration=12.0, rate=25_000.0, occupancy=0.0)
    volts, moments = (
        clean.channels["torque_V"].values.copy(),
        [(22_500, 62_500), (130_000, 170_000), (200_000, 237_500)],
    )
    for start, stop in moments:
        volts[start:stop] *= 0.72
    found = gain_moments(clean.with_values("torque_V", volts))
    ends = [edge for each in found for edge in (each.start, each.stop)]
    assert ends == pytest.approx([edge for moment in moments for edge in moment], abs=0.02 * 25_000)
    assert [each.factor for each in found] == pytest.approx([0.72] * 3, rel=0.03)
