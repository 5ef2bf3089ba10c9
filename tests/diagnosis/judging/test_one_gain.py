"""Lines that all change by one factor at one moment are a gain that steps; one line that does, or none, is not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.judging.one_gain import one_gain
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario

RATE, LENGTH, SPEED = 2000.0, 12.0, 2 * np.pi * 25.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
ORDERS = (0.2, 0.4, 1.0, 2.0, 6.0, 7.0)
Made = Callable[..., Observed]


@pytest.fixture
def made(by_hand: Callable[..., Observed]) -> Made:
    """A run with six lines, of which those of some orders change by a factor at a moment, under white noise."""

    def run(*, seed: int, factor: float = 1.0, at: float = 7.0, of: tuple[float, ...] = ORDERS, noise: float = 0.005,
            profile: str = "steady") -> Observed:  # fmt: skip
        rng = np.random.default_rng(seed)
        later = np.where(at <= TIME, factor, 1.0)
        torque = 0.1 + noise * rng.standard_normal(TIME.size)
        for each in ORDERS:
            line = 0.05 / np.sqrt(each) * np.cos(each * SPEED * TIME + rng.uniform(0, 6))
            torque = torque + line * (later if each in of else 1.0)
        return by_hand(torque, SPEED * TIME, rate=RATE, name=str(seed), profile=profile)

    return run


def told(wear_rig: Scenario, *runs: Observed) -> tuple[str, Mismatch] | None:
    seen = tuple(features(run, [order(each) for each in ORDERS]) for run in runs)
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    return one_gain(Case(nominal=wear_rig.rig, runs=runs, seen=seen, model=model, left=()))


@pytest.mark.parametrize(("factor", "at"), [(0.8, 7.0), (1.25, 4.0)])
def test_a_gain_that_steps_is_told_with_its_run_its_moment_and_its_factor(
    factor: float, at: float, wear_rig: Scenario, made: Made
) -> None:
    found = told(wear_rig, made(seed=1), made(seed=2, factor=factor, at=at))
    assert found is not None
    sentence, mismatch = found
    assert f"{factor:.2f} times as large" in sentence
    assert mismatch.recordings == ("2",)
    assert mismatch.at == pytest.approx(at, abs=0.7)
    assert mismatch.excess_dB == pytest.approx(20 * np.log10(factor), abs=0.3)
    assert mismatch.p_value < 1e-4


@pytest.mark.parametrize("seed", range(6))
def test_what_stays_as_it_is_has_no_step(seed: int, wear_rig: Scenario, made: Made) -> None:
    assert told(wear_rig, made(seed=seed), made(seed=100 + seed, noise=0.05)) is None


def test_one_line_that_changes_is_no_gain(wear_rig: Scenario, made: Made) -> None:
    assert told(wear_rig, made(seed=5, factor=0.5, of=(1.0,))) is None


def test_a_run_whose_speed_moves_tells_nothing(wear_rig: Scenario, made: Made) -> None:
    assert told(wear_rig, made(seed=6, factor=0.8, profile="ramp")) is None
