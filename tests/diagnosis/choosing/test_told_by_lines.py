"""A low-pass that the rig's own lines tell is named at half of what a spectrum alone must show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import told_by_lines as telling
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.scenario.model import Scenario


def model(scenario: Scenario, *, bands: float, lines: float) -> Calibrated:
    misfits = (Misfit(np.full(10, bands), np.full(6, lines), np.zeros(0)),)
    cost = float(sum(np.square(one.all()).sum() for one in misfits))
    return Calibrated(scenario.rig, (), np.zeros(0), np.zeros((0, 0)), misfits, cost)


@pytest.fixture
def case(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> Case:
    """Nothing stands out in it."""
    monkeypatch.setattr(telling, "mismatches", lambda _: ())
    return Case(nominal=wear_rig.rig, runs=(), seen=(), model=model(wear_rig, bands=1.8, lines=2.0), left=())


def trial(case: Case, fitted: Calibrated, **of_candidate: object) -> Trial:
    candidate = Candidate(mechanism="sensor_bandwidth", parts=(), knobs=(), **of_candidate)  # type: ignore[arg-type]
    return Trial(candidate, fitted, case.model.cost - fitted.cost)


@pytest.fixture
def foretold(monkeypatch: pytest.MonkeyPatch, case: Case, wear_rig: Scenario) -> None:
    """The held-out lines fall as the fitted ones do."""
    after = model(wear_rig, bands=1.8, lines=0.5)
    turns = iter((case.model.misfits, after.misfits) * 4)
    monkeypatch.setattr(telling, "misfits_of", lambda *_: next(turns))


@pytest.mark.usefixtures("foretold")
def test_lines_tell_what_bands_do_not(case: Case, wear_rig: Scenario) -> None:
    lines_fall = trial(case, model(wear_rig, bands=1.8, lines=0.5), resembled=True)
    bands_fall = trial(case, model(wear_rig, bands=0.4, lines=2.0), resembled=True)
    assert bands_fall.gain > lines_fall.gain
    assert telling.told_by_lines(case, lines_fall, ())
    assert not telling.told_by_lines(case, bands_fall, ())


@pytest.mark.usefixtures("foretold")
def test_beside_what_was_found_lines_tell_its_rest(case: Case, wear_rig: Scenario) -> None:
    lines_fall = trial(case, model(wear_rig, bands=1.8, lines=0.5), resembled=True)
    assert not telling.told_by_lines(replace(case, accepted=(lines_fall.candidate,)), lines_fall, ())


@pytest.mark.usefixtures("foretold")
def test_what_nothing_resembles_is_not_asked(case: Case, wear_rig: Scenario) -> None:
    assert not telling.told_by_lines(case, trial(case, model(wear_rig, bands=1.8, lines=0.5)), ())


def test_lines_that_do_not_come_again_tell_nothing(
    case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(telling, "misfits_of", lambda *_: case.model.misfits)
    assert not telling.told_by_lines(case, trial(case, model(wear_rig, bands=1.8, lines=0.5), resembled=True), ())


def test_what_is_sought_at_many_places_is_spared_its_price_where_lines_tell_it(
    case: Case, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    mode = trial(case, model(wear_rig, bands=1.8, lines=0.5), resembled=True, price=20.0, spared=20.0)
    dull = trial(case, model(wear_rig, bands=1.8, lines=1.6), resembled=True, price=20.0, spared=20.0)
    assert telling.spared(case, mode).gain == pytest.approx(mode.gain + 20.0)
    assert telling.spared(case, dull) == dull
    monkeypatch.setattr(telling, "mismatches", lambda _: (object(),))  # another effect stands out there
    assert telling.spared(case, mode) == mode
