"""Blows of what slips under load: found in all loaded runs, never where hits come, flanks strike or sides change."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.slips import slips
from torquerig.scenario.model import Scenario

RATE, LENGTH, HELD, RINGS = 5000.0, 12.0, 0.02, 0.03
TIME = np.arange(round(RATE * LENGTH)) / RATE
AT = (1.3, 4.0, 4.9, 8.2)


@pytest.fixture
def made(wear_rig: Scenario, record: Callable[..., Recording]) -> Callable[..., Recording]:
    """A torque of some level [V] with noise, and from each moment on a share of it held, then a blow that rings."""
    runs: dict[str, Recording] = {}

    def run(
        level: float, *, seed: int, at: tuple[float, ...] = (), profile: str = "steady", one_way: bool = False
    ) -> Recording:
        if profile not in runs:
            runs[profile] = record(wear_rig.rig, seed, duration=LENGTH, rate=RATE, profile=profile)
        volts = level + 0.02 * np.random.default_rng(seed).standard_normal(TIME.size)
        if profile == "reversal":
            volts *= np.sign(np.sin(2 * np.pi * (TIME + 0.1) / 6.0))
        for start in at:
            volts[(start <= TIME) & (start + HELD > TIME)] *= 1.0 if one_way else 0.3
            since = TIME - start - HELD
            ring = np.where(since >= 0, np.exp(-np.maximum(since, 0) / RINGS) * np.sin(2 * np.pi * 120.0 * since), 0.0)
            volts += 40 * 0.02 * (np.abs(ring) if one_way else ring)
        return runs[profile].with_values("torque_V", volts)

    return run


def test_the_moments_reach_from_where_it_lets_go_to_where_it_has_rung_out(made: Callable[..., Recording]) -> None:
    first, second = slips([made(0.5, seed=1, at=AT), made(0.5, seed=2, at=AT[1:])])
    assert first is not None
    assert second is not None
    assert len(first.moments) == 4
    assert len(second.moments) == 3
    for (start, stop), at in zip(first.moments, AT, strict=True):
        assert at - 0.02 < start / RATE <= at + 0.004, "the torque that is held before the blow goes with it"
        assert at + HELD + 3 * RINGS < stop / RATE < at + 0.3
    assert first.furthest == pytest.approx(40 * 0.02, rel=0.2)
    assert first.spreads == pytest.approx(first.furthest / 0.02, rel=0.1)


def test_smaller_ones_are_known_by_the_larger(made: Callable[..., Recording]) -> None:
    """A run without load has blows that no loaded run would be asked for, once there are some under load."""
    idle = made(0.0, seed=3, at=AT[:2])
    idle = idle.with_values("torque_V", 0.35 * idle.channels["torque_V"].values + 0.01 * np.sin(40 * TIME))
    loaded, beside = slips([made(0.5, seed=1, at=AT), idle])
    assert loaded is not None
    assert beside is not None
    assert len(beside.moments) == 2
    assert slips([made(0.5, seed=1), idle]) == (None, None), "flanks strike so where there is no load"


@pytest.mark.long
@pytest.mark.parametrize("case", ["one way", "a few", "not in all", "none under load", "sides change", "a rhythm"])
def test_what_is_none(case: str, made: Callable[..., Recording]) -> None:
    runs = {
        "one way": [made(0.5, seed=1, at=AT, one_way=True)],
        "a few": [made(0.5, seed=1, at=AT[:2])],
        "not in all": [made(0.5, seed=1, at=AT), made(0.5, seed=2)],
        "none under load": [made(0.0, seed=1, at=AT)],
        "a rhythm": [made(0.5, seed=1, at=(1.0, 3.0, 4.0, 7.0)), made(0.5, seed=2, at=(1.2, 1.9, 3.3))],
        "sides change": [made(0.5, seed=1, profile="reversal")],
    }[case]
    assert slips(runs) == (None,) * len(runs)


def test_a_run_that_turns_back_has_its_blows_and_not_its_reversals(made: Callable[..., Recording]) -> None:
    _, turning = slips([made(0.5, seed=1, at=AT), made(0.5, seed=2, at=(4.4, 7.5), profile="reversal")])
    assert turning is not None
    assert [round(start / RATE, 1) for start, _ in turning.moments] == [4.4, 7.5]
