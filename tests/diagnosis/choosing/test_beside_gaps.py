"""A gap and other effects: closed flanks excuse no line, and chatter that another effect explains better is no gap."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import beside_gaps, opened_gap
from torquerig.diagnosis.choosing.beside_gaps import chatter_outdone, gained_by_closed_lines
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.diagnosis.looking.features import Features
from torquerig.inference.places import order
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario


def model(rig: Rig, *lines: float) -> Calibrated:
    """One line in each of so many runs, missed by so much."""
    misfits = tuple(Misfit(np.zeros(0), np.array([line]), np.zeros(0)) for line in lines)
    return Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), misfits, 0.0)


@pytest.fixture
def case(wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> Case:
    """A loaded run, in which flanks stay closed, and one without load, in which they part."""
    monkeypatch.setattr(beside_gaps, "flanks_may_part", lambda features: features.parts)
    runs = cast("tuple[Features, ...]", (SimpleNamespace(parts=False), SimpleNamespace(parts=True)))
    told = Case(nominal=wear_rig.rig, runs=(), seen=runs, model=model(wear_rig.rig, 3.0, 3.0), left=())
    object.__setattr__(told, "from_zero", runs)
    return told


def test_a_line_that_goes_where_flanks_stay_closed_is_no_detail_of_a_gap(case: Case) -> None:
    line = Candidate(mechanism="cogging", parts=(), knobs=(), place=order(56.0))
    closed, parted = (Trial(line, model(case.nominal, *left), 9.0) for left in ((0.0, 3.0), (3.0, 0.0)))
    assert gained_by_closed_lines(case, closed) == pytest.approx(2 * 9 / (1 + np.sqrt(1 + 9 / 16)))
    assert gained_by_closed_lines(case, parted) == 0.0
    assert gained_by_closed_lines(case, replace(closed, candidate=replace(line, place=None))) == 0.0


@pytest.mark.parametrize(
    ("flights", "gains", "outdone"),
    [(0, (900.0, 1000.0), True), (0, (900.0, 800.0), False), (9, (900.0, 1000.0), False)],
    ids=["a mode gains more", "it gains less", "flights are seen"],
)
def test_chatter_that_another_effect_explains_better_tells_no_gap(
    flights: int, gains: tuple[float, float], outdone: bool, case: Case, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opened_gap, "flights_beyond_lines", lambda _: flights)
    gap, mode = (
        Trial(Candidate(mechanism=name, parts=(), knobs=()), case.model, gain)
        for name, gain in zip(("backlash", "torsional_mode"), gains, strict=True)
    )
    assert chatter_outdone(case, gap, [gap, mode]) is outdone
    assert not chatter_outdone(case, mode, [gap, mode])
