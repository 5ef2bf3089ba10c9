"""A load that falls along its runs, or lets go at once, is told; chance, idle runs and ramps are not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.signal import butter, lfilter

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.judging.load_over_time import load_over_time
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch

RATE, LENGTH, SPEED = 2000.0, 12.0, 105.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
Made = Callable[..., Observed]


def load(seed: int) -> NDArray[np.float64]:
    """Hits of 10 % that decay in 4 ms and a slow variation of 6 %, as a share of the mean."""
    rng = np.random.default_rng(seed)
    hits = (rng.random(TIME.size) < 60 / RATE) * rng.gamma(1.5, size=TIME.size)
    shots = lfilter([1.0], [1.0, -np.exp(-1 / (0.004 * RATE))], hits)
    slow = lfilter(*butter(2, 1.5, fs=RATE), rng.standard_normal(TIME.size))
    return np.asarray(1 + 0.10 * (shots - shots.mean()) / shots.std() + 0.06 * slow / slow.std())


@pytest.fixture
def made(by_hand: Callable[..., Observed]) -> Made:
    def run(
        torque: NDArray[np.float64], *, percent: float = 11.0, name: str = "run", profile: str = "steady"
    ) -> Observed:
        one = by_hand(torque, SPEED * TIME, rate=RATE, name=name, profile=profile)
        return replace(one, recording=replace(one.recording, run=replace(one.run, occupancy_percent=percent)))

    return run


def told(*runs: Observed) -> tuple[str, Mismatch] | None:
    return load_over_time(cast("Case", SimpleNamespace(runs=runs)))


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_bed_that_wears_in_is_told_in_all_its_runs(way: float, made: Made) -> None:
    worn = 1 - 0.3 * (1 - np.exp(-TIME / 4.0))
    found = told(made(way * 2 * load(1) * worn, name="a"), made(way * load(2) * worn, name="b"))
    assert found is not None
    assert "falls by" in found[0]
    assert found[1].recordings == ("a", "b")
    assert found[1].p_value < 1e-8


def test_a_jam_that_lets_go_is_told_where_it_first_did(made: Made) -> None:
    since = (TIME - 0.5) % 2.0
    jam = np.where((since > 1.2) & (TIME > 1.0), 0.7 * (since - 1.2) / 0.8, 0.0)  # builds up, and is gone at once
    found = told(made(load(3), name="a"), made(2 * (load(4) + jam), name="b"))
    assert found is not None
    assert found[1].recordings == ("b",)
    assert found[1].at == pytest.approx(2.5, abs=0.03)


@pytest.mark.parametrize("seed", range(8))
def test_chance_has_no_course_and_lets_nothing_go(seed: int, made: Made) -> None:
    assert told(made(load(10 + seed)), made(3 * load(30 + seed), percent=21.0)) is None


def test_a_rise_is_no_fall_and_what_is_no_load_is_not_asked(made: Made) -> None:
    worn = load(5) * (1 - 0.3 * TIME / LENGTH)
    assert told(made(worn, percent=0.0), made(worn, profile="ramp")) is None
    assert told() is None
