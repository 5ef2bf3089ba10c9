"""The cost with all numbers free, told without a fit: exact where residuals are straight in the numbers."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.fitting import profiled
from torquerig.diagnosis.fitting.calibration import LIMIT, Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.scenario.model import Scenario

RNG = np.random.default_rng(5)
SLOPES = RNG.standard_normal((30, 3))
AT = np.array([0.4, -0.2, 0.1])


def cost(scenario: Scenario, missed: np.ndarray, monkeypatch: pytest.MonkeyPatch, *, derivatives: bool = True) -> float:
    empty = np.zeros(0)
    monkeypatch.setattr(profiled, "misfits_of", lambda *_: (Misfit(empty, empty, missed),))
    slopes = SLOPES if derivatives else None
    return profiled.profiled_cost(
        Calibrated(scenario.rig, (), AT, np.eye(3), (), 0.0, (), slopes), scenario.rig, seen=()
    )


def test_it_is_the_least_cost_of_straight_residuals(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    missed = 0.2 * RNG.standard_normal(30)
    step = -np.linalg.solve(SLOPES.T @ SLOPES + np.eye(3), SLOPES.T @ missed + AT)
    least = float(((missed + SLOPES @ step) ** 2).sum() + ((AT + step) ** 2).sum())
    told = cost(wear_rig, missed, monkeypatch)
    assert told == pytest.approx(least, rel=0.02)  # robust squares of small residuals are squares, nearly
    assert told < cost(wear_rig, missed, monkeypatch, derivatives=False)


def test_what_the_numbers_make_up_for_costs_their_positions_alone(
    wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = cost(wear_rig, SLOPES @ np.array([1.0, 0.0, 0.0]), monkeypatch)
    assert told == pytest.approx(float(((AT - [1.0, 0.0, 0.0]) ** 2).sum()), rel=0.1)


def test_no_number_goes_beyond_its_limit(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    far = cost(wear_rig, SLOPES @ np.array([100.0, 0.0, 0.0]), monkeypatch)
    assert far > (100 - LIMIT - 1) * 1.0
