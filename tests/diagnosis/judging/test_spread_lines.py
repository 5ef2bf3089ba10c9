"""A line whose phase jumps is found between the bands; noise, sharp lines and skirts of lines are none."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.judging.spread_lines import spread_line
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import order
from torquerig.scenario.model import Scenario

RATE, LENGTH, ORDER = 5000.0, 12.0, 7.25
TIME = np.arange(int(RATE * LENGTH)) / RATE
Made = Callable[..., Observed]


@pytest.fixture
def made(by_hand: Callable[..., Observed]) -> Made:
    """A run of noise, with a line of this amplitude whose phase jumps so often a second."""

    def run(speed: float, *, seed: int, line: float = 0.0, rate: float = 3.0, order: float = ORDER) -> Observed:
        rng = np.random.default_rng(seed)
        jumps = np.cumsum(rng.random(TIME.size) < rate / RATE)
        phase = rng.uniform(0, 2 * pi, jumps[-1] + 1)[jumps]
        torque = line * np.cos(order * speed * TIME + phase) + 2e-2 * rng.standard_normal(TIME.size)
        return by_hand(torque, speed * TIME, rate=RATE, name=f"{speed:g}")

    return run


def found(wear_rig: Scenario, *runs: Observed, known: tuple[float, ...] = ()) -> list[Mismatch]:
    seen = tuple(features(run, [order(at) for at in known]) for run in runs)
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    recorded = spread_line(Case(nominal=wear_rig.rig, runs=runs, seen=seen, model=model, left=()))
    return [] if recorded is None else [recorded]


def test_a_line_that_jumps_is_told_at_its_order_by_two_speeds(wear_rig: Scenario, made: Made) -> None:
    (recorded,) = found(wear_rig, made(100.0, seed=1, line=4e-3), made(70.0, seed=2, line=4e-3))
    assert (recorded.domain, recorded.axis) == ("order", "motor_shaft")
    assert recorded.at == pytest.approx(ORDER, rel=0.02)
    assert recorded.recordings == ("100", "70")
    assert recorded.p_value < 1e-3
    # the median over a width w of a Lorentzian, a^2 L / (L^2 + (pi w / 2)^2) at L jumps a second, over 2 s^2 / rate
    width = recorded.width * 85.0 / (2 * pi)
    assert width == pytest.approx(1.5, rel=0.02) or width == pytest.approx(3.0, rel=0.02)
    line = 4e-3**2 * 3.0 / (3.0**2 + (0.5 * pi * width) ** 2)
    assert recorded.excess_dB == pytest.approx(10 * np.log10(line / (2 * 2e-2**2 / RATE)), abs=2.0)


def test_runs_that_show_it_little_show_it_together(wear_rig: Scenario, made: Made) -> None:
    runs = [made(speed, seed=seed, line=2.2e-3) for seed, speed in enumerate((100.0, 83.0, 70.0, 58.0), start=1)]
    assert all(found(wear_rig, run) == [] for run in runs[:2])
    (recorded,) = found(wear_rig, *runs)
    assert recorded.domain == "order"
    assert recorded.at == pytest.approx(ORDER, rel=0.02)


def test_one_speed_tells_its_frequency(wear_rig: Scenario, made: Made) -> None:
    (recorded,) = found(wear_rig, made(100.0, seed=1, line=4e-3), made(100.0, seed=2))
    assert (recorded.domain, recorded.axis) == ("frequency", "Hz")
    assert recorded.at == pytest.approx(ORDER * 100.0 / (2 * pi), abs=1.5)


@pytest.mark.parametrize("seed", range(5))
def test_noise_is_none(seed: int, wear_rig: Scenario, made: Made) -> None:
    assert found(wear_rig, made(100.0, seed=seed), made(70.0, seed=seed + 50)) == []


def test_a_line_that_holds_its_phase_is_none(wear_rig: Scenario, made: Made) -> None:
    assert found(wear_rig, made(100.0, seed=1, line=2e-2, rate=1e-9), known=(ORDER,)) == []
    assert found(wear_rig, made(100.0, seed=1, line=2e-2, rate=1e-9)) == []


def test_a_skirt_on_both_sides_of_a_known_line_is_none(by_hand: Callable[..., Observed], wear_rig: Scenario) -> None:
    """Where the angle was not measured, a shaft that swings spreads its own lines, and evenly to both sides."""
    rng = np.random.default_rng(3)
    swing = np.cumsum(rng.standard_normal(TIME.size)) * 0.06
    swing -= np.convolve(swing, np.ones(2500) / 2500, mode="same")
    torque = 0.1 * np.cos(12 * 100.0 * TIME + swing) + 2e-3 * rng.standard_normal(TIME.size)
    run = by_hand(torque, 100.0 * TIME, rate=RATE, measured=False)
    assert found(wear_rig, run, known=(12.0,)) == []
