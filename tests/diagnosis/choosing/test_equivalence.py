"""Whether two models can be told apart: the difference of their misfits against closed forms and against chance."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate
from torquerig.diagnosis.choosing.equivalence import CHANCE, difference, equivalents
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.inference.knobs import Knob
from torquerig.scenario.model import Scenario

NONE = np.zeros(0)


def of_levels(values: np.ndarray) -> Misfit:
    return Misfit(bands=NONE, lines=np.zeros((1, 0)), level=np.asarray(values, dtype=float))


def test_a_model_does_not_differ_from_itself() -> None:
    same = of_levels(np.array([0.3, -1.0, 2.0]))
    found = difference([same], [same])
    assert (found.excess, found.spread, found.apart) == (0.0, 0.0, 0.0)


def test_small_residuals_give_the_closed_form() -> None:
    """Far below 4 the robust residual is the residual: sum(b^2 - a^2), and 2 |b - a| for its spread."""
    a, b = np.array([0.01, -0.02, 0.0]), np.array([0.03, 0.01, -0.04])
    found = difference([of_levels(a)], [of_levels(b)])
    assert found.excess == pytest.approx(float((b**2 - a**2).sum()), rel=1e-3)
    assert found.apart == pytest.approx(float(np.linalg.norm(b - a)), rel=1e-3)
    assert found.spread == pytest.approx(2 * found.apart)


def test_the_spread_is_that_of_chance() -> None:
    """Residuals of unit spread about the better model: (excess - |d|^2) / spread has a variance of 1."""
    rng = np.random.default_rng(5)
    step = 0.3 * rng.standard_normal(60)
    scores = []
    for _ in range(1500):
        noise = rng.standard_normal(60)
        found = difference([of_levels(noise)], [of_levels(noise + step)])
        scores.append((found.excess - found.apart**2) / found.spread)
    # robust residuals are a little smaller than the residuals, blocks of one draw a little larger or smaller than all
    assert np.mean(scores) == pytest.approx(0.0, abs=0.1)
    assert np.std(scores) == pytest.approx(0.9, abs=0.1)


def test_a_rival_twice_chance_away_is_rarely_called_alike() -> None:
    rng = np.random.default_rng(6)
    step = np.full(40, 9.0 / np.sqrt(40))
    alike = 0
    for _ in range(400):
        noise = rng.standard_normal(40)
        found = difference([of_levels(noise)], [of_levels(noise + step)])
        alike += found.excess <= CHANCE * found.spread
    # the excess is |d|^2 = 81 beside a spread of 2 |d| = 18: 4.5 spreads
    # and a z beyond 2.2 sigma of it, once in seventy, more often where blocks of four widen one draw's spread
    assert alike < 40


def test_neighbours_that_stray_together_widen_the_spread() -> None:
    step = np.full(8, 0.5)
    together = difference([of_levels(np.full(8, 2.0))], [of_levels(np.full(8, 2.0) + step)])
    apart = difference([of_levels(np.tile([2.0, -2.0], 4))], [of_levels(np.tile([2.0, -2.0], 4) + step)])
    assert together.spread > 3 * apart.spread


def test_numbers_far_from_their_nominal_values_count_as_residuals() -> None:
    same = of_levels(np.zeros(3))
    found = difference([same], [same], also=(np.array([0.0, 1.0]), np.array([2.0, 1.0])))
    assert found.excess == pytest.approx(4.0)


def test_rivals_are_told_apart_where_one_model_has_numbers_more(wear_rig: Scenario) -> None:
    """An effect between them was dropped since: only numbers that both have count as residuals."""

    def trial(mechanism: str, level: float, positions: dict[str, float]) -> Trial:
        knobs = tuple(Knob(*name.split("."), 1.0) for name in positions)
        misfits, at = (of_levels(np.full(40, level)),), np.array(list(positions.values()))
        model = Calibrated(wear_rig.rig, knobs, at, np.eye(at.size), misfits, 0.0)
        return Trial(Candidate(mechanism=mechanism, parts=(), knobs=()), model, 50.0)

    best = trial("gear_mesh", 0.5, {"motor.inertia": 0.1, "mesh.size": 3.0})
    more = {"motor.inertia": 0.2, "hum.frequency": 2.0, "drag.coefficient": 4.0}
    assert [one.candidate.mechanism for one in equivalents(best, [trial("quadratic_drag", 0.51, more)])] == [
        "quadratic_drag"
    ]
    assert equivalents(best, [trial("quadratic_drag", 3.0, more)]) == ()
