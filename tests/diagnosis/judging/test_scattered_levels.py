"""A moving run's slow torque follows a course, right or wrong; what jumps from stretch to stretch is no course."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from numpy.typing import NDArray

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.judging.scattered_levels import scatter, scattered_levels
from torquerig.diagnosis.looking.observed import Stretch
from torquerig.diagnosis.opening import followed, opened
from torquerig.diagnosis.sample_findings import sample_findings
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

COUNT = 15


def case_of(
    *runs: NDArray[np.float64], steady: bool = False, corrections: tuple[int, ...] = (), occupancy: float = 0.0
) -> Case:
    """Runs whose levels miss the model by so many spreads, in stretches of one second."""
    seen = [
        SimpleNamespace(
            observed=SimpleNamespace(
                name=f"run{at}", steady=steady, rate=100.0, run=SimpleNamespace(occupancy_percent=occupancy)
            ),
            parts=[Stretch(100 * row, 100 * row + 100, held=False) for row in range(levels.size)],
        )
        for at, levels in enumerate(runs)
    ]
    misfits = [SimpleNamespace(level=levels) for levels in runs]
    return cast("Case", SimpleNamespace(seen=seen, model=SimpleNamespace(misfits=misfits, corrections=corrections)))


def noise(seed: int, size: float, count: int = COUNT) -> NDArray[np.float64]:
    return np.random.default_rng(seed).normal(0.0, size, count)


def test_independent_levels_scatter_by_their_spread_whatever_course_they_follow() -> None:
    course = np.linspace(-20.0, 20.0, 4000)
    assert scatter(noise(1, 2.5, 4000) + course) == pytest.approx(2.5, rel=0.05)
    assert scatter(course) == pytest.approx(0.0, abs=1e-9)


def test_levels_that_jump_are_told_with_the_worst_moment() -> None:
    levels = noise(2, 0.6)
    levels[[4, 9, 10]] += (6.0, -5.0, 4.0)
    (left,) = scattered_levels(case_of(levels), 100.0)
    assert (left.domain, left.axis, left.recordings) == ("time", "s", ("run0",))
    assert left.at == pytest.approx(9.5, abs=1.01)
    assert left.p_value < 1e-3


@pytest.mark.parametrize("seed", range(20))
def test_chance_and_a_wrong_course_are_not_told(seed: int) -> None:
    bent = 12.0 * np.exp(-np.arange(COUNT) / 4.0)
    assert [*scattered_levels(case_of(noise(seed, 1.0) + bent, noise(seed + 50, 1.0)), 100.0)] == []


def test_a_load_may_wander_somewhat_more_than_the_model_knows() -> None:
    wanders = 1.75 * noise(2, 1.0) / scatter(noise(2, 1.0))
    assert [*scattered_levels(case_of(wanders), 100.0)] != []
    assert [*scattered_levels(case_of(wanders, occupancy=5.0), 100.0)] == []
    assert [*scattered_levels(case_of(2.0 * wanders, occupancy=5.0), 100.0)] != []


def test_where_nothing_can_be_told_nothing_is_asked() -> None:
    jumping = noise(3, 4.0)
    assert [*scattered_levels(case_of(jumping, steady=True), 100.0)] == []
    assert [*scattered_levels(case_of(jumping, corrections=(1,)), 100.0)] == []
    assert [*scattered_levels(case_of(jumping[:7]), 100.0)] == []
    assert [*scattered_levels(case_of(jumping), 100.0)] != []


@pytest.mark.long
def test_a_zero_that_jumps_in_an_idle_ramp_is_left(wear_rig: Scenario, record: Callable[..., Recording]) -> None:
    """0.3 V for half a second at a time; without it nothing is left."""
    runs = [record(wear_rig.rig, 3, occupancy=5.0, duration=8.0)]
    runs.append(record(wear_rig.rig, 4, occupancy=0.0, duration=12.0, profile="ramp"))
    rng = np.random.default_rng(5)
    edges = np.cumsum(rng.exponential(0.5, 100))
    high = np.searchsorted(edges, np.arange(runs[1].samples) / runs[1].sample_rate) % 2
    jumping = runs[1].with_values("torque_V", runs[1].channels["torque_V"].values + 0.3 * high)

    def left(*recordings: Recording) -> set[Any]:
        faults = sample_findings(recordings, wear_rig.rig)
        case, _ = opened(wear_rig, followed(recordings, faults.recordings, wear_rig.rig), wear_rig.rig, faults)
        return {each.domain for each in mismatches(case)}

    assert left(*runs) == set()
    assert "time" in left(runs[0], jumping)
