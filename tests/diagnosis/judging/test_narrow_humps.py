"""Noise in one band: a line whose phase jumps is found at its order or frequency, one run alone tells nothing."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.expecting.expectation import Expectation, expected
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.judging import band_excess
from torquerig.diagnosis.judging import narrow_humps as humps
from torquerig.diagnosis.judging.narrow_humps import _smeared_lines, narrow_humps
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

RATE, LENGTH, ORDER = 5000.0, 12.0, 60.4
TIME = np.arange(int(RATE * LENGTH)) / RATE
ByHand = Callable[..., Observed]


@pytest.fixture
def seen(by_hand: ByHand, wear_rig: Scenario) -> Callable[..., Features]:
    """Noise, and in it a line whose phase jumps twice a second, at an order or at a frequency."""

    def made(speed: float, *, seed: int, order: float = 0.0, frequency: float = 0.0) -> Features:
        rng = np.random.default_rng(seed)
        jumps = np.cumsum(rng.random(TIME.size) < 2.0 / RATE)
        phase = rng.uniform(0, 2 * pi, jumps[-1] + 1)[jumps]
        line = np.cos((order * speed + 2 * pi * frequency) * TIME + phase)
        torque = 1.0 + 2e-2 * rng.standard_normal(TIME.size) + (2e-2 * line if order or frequency else 0.0)
        return features(by_hand(torque, speed * TIME, rate=RATE, name=f"{speed:g}"), [])

    return made


def found(wear_rig: Scenario, *runs: Features, beyond: Sequence[Correction] = ()) -> list[tuple[str, float]]:
    # at such orders the load has died out and the model is flat, as the noise is
    rig = wear_rig.rig
    model = Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    case = Case(nominal=rig, runs=tuple(run.observed for run in runs), seen=runs, model=model, left=())
    return [(mismatch.domain, mismatch.at) for mismatch in narrow_humps(case, 1e3, beyond)]


def test_a_line_that_jumps_is_found_at_its_order(wear_rig: Scenario, seen: Callable[..., Features]) -> None:
    ((domain, at),) = found(wear_rig, seen(100.0, seed=1, order=ORDER), seen(70.0, seed=2, order=ORDER))
    assert domain == "order"
    assert at == pytest.approx(ORDER, rel=0.06)  # bands are 9 % wide


def test_one_that_stays_is_found_at_its_frequency(wear_rig: Scenario, seen: Callable[..., Features]) -> None:
    fixed = ORDER * 100.0 / (2 * pi)
    ((domain, at),) = found(wear_rig, seen(100.0, seed=1, frequency=fixed), seen(70.0, seed=2, frequency=fixed))
    assert domain == "frequency"
    assert at == pytest.approx(fixed, rel=0.06)


def test_one_speed_or_one_run_tells_nothing(wear_rig: Scenario, seen: Callable[..., Features]) -> None:
    assert found(wear_rig, seen(100.0, seed=1, order=ORDER), seen(100.0, seed=2, order=ORDER)) == []
    assert found(wear_rig, seen(100.0, seed=1, order=ORDER), seen(70.0, seed=2)) == []
    assert found(wear_rig, seen(100.0, seed=1), seen(70.0, seed=2)) == []


def test_what_simulations_have_as_well_is_none(wear_rig: Scenario, seen: Callable[..., Features]) -> None:
    """A strong ripple swings its own phase with the load: a simulation of it has the same skirt."""
    runs = seen(100.0, seed=1, order=ORDER), seen(70.0, seed=2, order=ORDER)
    there, without = (
        [seen(speed, seed=seed + 10, order=order).power for speed, seed in ((100.0, 1), (70.0, 2))]
        for order in (ORDER, 0.0)
    )
    beyond = [
        Correction(power=one / other, squares=np.zeros((1, 0)), level=np.zeros(1), turning=None)
        for one, other in zip(there, without, strict=True)
    ]
    assert found(wear_rig, *runs)
    assert found(wear_rig, *runs, beyond=beyond) == []


@pytest.mark.parametrize(
    ("spreads", "high", "told"),
    [
        ((4.9, 6.4), (1.1, 1.6), True),  # 8.1 together
        ((4.2, 6.0), (1.1, 1.6), False),  # 7.3 together
        ((3.9, 9.0), (1.1, 1.6), False),  # a run shows nothing
        ((4.9, 6.4), (0.8, 1.6), False),  # what rises so little may be the load's own
        ((4.1, 8.1), (0.8, 1.6), True),  # one that is clear alone asks the other only whether it is there
    ],
)
def test_two_runs_may_be_as_clear_together_as_one_alone(
    spreads: tuple[float, float], high: tuple[float, float], told: bool, wear_rig: Scenario,
    seen: Callable[..., Features], monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    """A line of order 7.5 whose phase jumped stood out by 4.9 and 6.4 spreads, in single bands of two speeds."""
    runs = seen(100.0, seed=1), seen(70.0, seed=2)
    made = []
    for run, spread, height in zip(runs, spreads, high, strict=True):
        at = int(np.argmin(np.abs(run.band - ORDER * run.observed.mean_speed / (2 * pi))))
        alone = np.arange(run.band.size) == at
        made.append(humps._Heights(run, height * alone, spread * alone))
    monkeypatch.setattr(humps, "band_excesses", lambda case, beyond: made)
    monkeypatch.setattr(humps, "_heights", lambda each: each)
    assert [domain for domain, _ in found(wear_rig, *runs)] == ["order"] * told


@pytest.mark.parametrize(
    ("measured", "share", "smeared"), [(False, 0.02, True), (False, 0.2, False), (True, 0.02, False)]
)
def test_what_a_followed_angle_smears_of_a_line_is_none(
    measured: bool, share: float, smeared: bool, by_hand: ByHand
) -> None:
    """An angle that was followed leaves a part of a strong line in its band; more than that is something else."""
    torque = 1.0 + 1e-3 * np.random.default_rng(4).standard_normal(TIME.size) + 0.3 * np.cos(ORDER * 100.0 * TIME)
    run = features(by_hand(torque, 100.0 * TIME, rate=RATE, measured=measured), [order(ORDER)])
    at = int(np.argmin(np.abs(run.band - ORDER * 100.0 / (2 * pi))))
    power = np.full(run.band.size, 1e-7)
    power[[at, 3]] = share * 0.5 * 0.3**2 / run.width[[at, 3]]
    told = _smeared_lines(replace(run, power=power))
    assert told[at] == smeared
    assert not told[3], "far from the line"


def test_where_the_model_doubts_itself_nothing_stands_out(
    wear_rig: Scenario, seen: Callable[..., Features], monkeypatch: pytest.MonkeyPatch
) -> None:
    def doubting(rig: Rig, features: Features) -> Expectation:
        return replace(expected(rig, features), power_tolerance=1.0)

    runs = seen(100.0, seed=1, order=ORDER), seen(70.0, seed=2, order=ORDER)
    assert found(wear_rig, *runs)
    monkeypatch.setattr(band_excess, "expected", doubting)
    assert not found(wear_rig, *runs)
