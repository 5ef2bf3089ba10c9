"""Pulses in a slow rhythm of fixed period are told by many small lines together; a load's chance keeps no rhythm."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.judging.slow_rhythm import slow_rhythm
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import frequency, order
from torquerig.scenario.model import Scenario

RATE, LENGTH, SPEED = 2000.0, 12.0, 105.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
Made = Callable[..., Observed]


@pytest.fixture
def made(by_hand: Callable[..., Observed]) -> Made:
    """A run under hits that decay in 4 ms, with half-sine pulses of 30 ms in a rhythm, and the shaft's own lines."""

    def run(*, seed: int, pulse: float = 0.0, period: float = 0.8, late: float = 0.0, name: str = "run") -> Observed:
        rng = np.random.default_rng(seed)
        hits = (rng.random(TIME.size) < 60 / RATE) * rng.gamma(1.5, size=TIME.size)
        load = lfilter([1.0], [1.0, -np.exp(-1 / (0.004 * RATE))], hits)
        load *= 0.1 / load.std()
        beats = np.arange(0.1, LENGTH, period) + late * rng.standard_normal(np.arange(0.1, LENGTH, period).size)
        since = TIME[:, None] - beats
        pulses = np.where((since > 0) & (since < 0.03), np.sin(np.pi * since / 0.03), 0.0).sum(axis=1)
        lines = 0.2 * np.cos(0.2 * SPEED * TIME) + 0.1 * np.cos(0.4 * SPEED * TIME + 1)
        return by_hand(1 + load + lines + pulse * pulses, SPEED * TIME, rate=RATE, name=name)

    return run


def told(wear_rig: Scenario, *runs: Observed, left: Sequence[Peak] = ()) -> Mismatch | None:
    places = [order(0.2), order(0.4), *(peak.place for peak in left)]
    seen = tuple(features(run, places) for run in runs)
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    return slow_rhythm(Case(nominal=wear_rig.rig, runs=runs, seen=seen, model=model, left=tuple(left)))


@pytest.mark.parametrize("period", [0.45, 0.8, 1.3])
def test_a_rhythm_is_told_with_its_frequency_and_its_runs(period: float, wear_rig: Scenario, made: Made) -> None:
    runs = [made(seed=seed, pulse=1.0, period=period, name=str(seed)) for seed in (1, 2)]
    found = told(wear_rig, *runs, made(seed=3, name="without"))
    assert found is not None
    assert found.recordings == ("1", "2")
    times = found.at * period  # every second pulse, or two to a period, are told by the same lines
    assert times == pytest.approx(1.0, rel=0.02) or times == pytest.approx(0.5, rel=0.02)
    assert found.p_value < 1e-9


def test_lines_of_the_rhythm_that_stand_out_by_themselves_count_too(wear_rig: Scenario, made: Made) -> None:
    """Strong pulses at idle leave thirty lines, of which fits take account as of any that a model lacks."""
    run = made(seed=1, pulse=3.0, period=0.8)
    lines = [Peak(place=frequency(1.25 * tooth), excess=90.0, runs=("run",), speeds=1) for tooth in range(2, 33)]
    found = told(wear_rig, run, left=lines)
    assert found is not None
    assert found.at == pytest.approx(1.25, rel=0.02) or found.at == pytest.approx(0.625, rel=0.02)


@pytest.mark.parametrize("seed", range(12))
def test_chance_keeps_no_rhythm(seed: int, wear_rig: Scenario, made: Made) -> None:
    assert told(wear_rig, made(seed=100 + seed)) is None


def test_pulses_at_random_moments_keep_none_either(wear_rig: Scenario, made: Made) -> None:
    assert told(wear_rig, made(seed=5, pulse=0.6, late=0.3)) is None
