"""A gap and a further effect: the width is told again around it, or without it, and less is asked of what it gains."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import around_gap
from torquerig.diagnosis.choosing.around_gap import gap_anew, told_again
from torquerig.diagnosis.choosing.convincing import convincing
from torquerig.diagnosis.choosing.gap_fits import FittedGap
from torquerig.diagnosis.choosing.revising import Accepted, with_gap
from torquerig.diagnosis.choosing.search import Tried
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.expecting.correction import Correction
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.errors import SimulationError
from torquerig.mechanisms import Backlash, QuadraticDrag
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

NARROW, WIDE = (
    Candidate(mechanism="backlash", parts=(Backlash(name="backlash", gear="gearbox", gap=gap),), knobs=())
    for gap in (1e-3, 5e-3)
)
DRAG = Candidate(mechanism="quadratic_drag", parts=(QuadraticDrag(name="quadratic_drag", coefficient=1e-3),), knobs=())


def model(rig: Rig, *levels: float, corrected: bool = True) -> Calibrated:
    misfits = (Misfit(np.zeros(0), np.zeros(0), np.array(levels)),)
    corrections = (Correction(np.zeros(0), np.zeros((0, 0)), np.zeros(0), None),) if corrected else ()
    cost = float(np.square(levels).sum())
    return Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), misfits, cost, corrections)


@pytest.fixture
def case(wear_rig: Scenario) -> Case:
    """A gap is in, and forty levels still miss by five spreads."""
    rig = NARROW.added_to(wear_rig.rig)
    return Case(nominal=wear_rig.rig, runs=(), seen=(), model=model(rig, *[5.0] * 40), left=(), accepted=(NARROW,))


@pytest.fixture
def beside(case: Case) -> Trial:
    fitted = model(DRAG.added_to(case.model.rig), *[3.0] * 40)
    return Trial(DRAG, fitted, case.model.cost - fitted.cost)


def told(case: Case, *levels: float) -> FittedGap:
    return FittedGap(WIDE, model(DRAG.added_to(case.nominal), *levels), 0.0, 0.0)


def test_the_gap_takes_its_new_width(case: Case, beside: Trial, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Rig] = []

    def fitted(bare: Case, base: Rig) -> FittedGap:
        asked.append(base)
        assert not bare.has("backlash")
        return told(case, *[1.0] * 40)

    monkeypatch.setattr(around_gap, "fitted_gap", fitted)
    again = told_again(case, beside)
    assert again is not None
    assert {part.name for part in asked[0].parts} - {part.name for part in case.nominal.parts} == {"quadratic_drag"}
    assert again.gap is WIDE
    assert again.gain == pytest.approx(40 * (25 - 1))
    assert again.model.rig.part("backlash") == WIDE.parts[0]
    first = Accepted(before=case, trial=Trial(NARROW, case.model, 100.0), tried=Tried((), ()))
    (swapped,) = with_gap([first], again.gap)
    assert swapped.trial.candidate is WIDE
    assert with_gap([first], None) == [first]


def test_a_width_that_comes_no_nearer_is_not_taken(case: Case, beside: Trial, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(bare: Case, base: Rig) -> FittedGap:
        raise SimulationError("stiff")

    for gap_trial in (lambda *_: told(case, *[3.5] * 40), lambda *_: None, failing):
        monkeypatch.setattr(around_gap, "fitted_gap", gap_trial)
        assert told_again(case, beside) is None
    assert told_again(replace(case, accepted=()), beside) is None


def test_a_gap_is_told_anew_beside_what_is_left(case: Case, monkeypatch: pytest.MonkeyPatch) -> None:
    """What it added to lines was simulated with an effect that is gone: nothing of that is asked again."""

    def fitted(bare: Case, base: Rig) -> FittedGap:
        assert not bare.has("backlash")
        assert not bare.model.corrections
        assert "backlash" not in {part.name for part in base.parts}
        return told(case, *[1.0] * 40)

    monkeypatch.setattr(around_gap, "fitted_gap", fitted)
    anew = gap_anew(case)
    assert anew is not None
    assert anew.accepted == (WIDE,)
    assert anew.model.rig.part("backlash") == WIDE.parts[0]
    monkeypatch.setattr(around_gap, "fitted_gap", lambda *_: None)
    assert gap_anew(case) is None


@pytest.mark.parametrize(("of_the_gap", "alone", "around"), [(1000.0, True, True), (6000.0, False, True)])
def test_less_is_asked_of_what_stands_beside_a_gap_told_again(
    of_the_gap: float, alone: bool, around: bool, case: Case
) -> None:
    """It gains 960: a sixth of what the gap gained may be the gap's own detail, unless that was told again."""
    fitted = model(DRAG.added_to(case.model.rig), *[1.0] * 40)
    beside = Trial(DRAG, fitted, case.model.cost - fitted.cost)
    earlier = [Trial(NARROW, case.model, of_the_gap)]
    judged = [convincing(case, one, earlier=earlier, held=()) for one in (beside, replace(beside, gap=WIDE))]
    assert judged == [alone, around]
