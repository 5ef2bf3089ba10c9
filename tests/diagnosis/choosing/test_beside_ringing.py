"""Impacts: what explains bands about their ringing may be a detail of it; a mode far below is none."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing.beside_ringing import details_of_ringing
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.diagnosis.looking.features import Features
from torquerig.mechanisms import BearingDefect
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

BANDS = np.array([50.0, 100.0, 200.0, 400.0, 800.0, 1600.0, 3200.0])
STRUCK = BearingDefect(
    name="bearing_defect", at="wear_part", order_output=5.4, ring_frequency=2000.0, damping=0.05, amplitude=0.2
)


def model(rig: Rig, missed: np.ndarray) -> Calibrated:
    misfits = (Misfit(missed, np.zeros(0), np.zeros(0)), Misfit(np.zeros(0), np.array([2.0]), np.zeros(0)))
    return Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), misfits, 0.0)


@pytest.mark.parametrize(
    ("taken", "resembled", "detail"),
    [
        ((100.0, 200.0, 400.0), True, False),
        ((800.0, 1600.0, 3200.0), True, True),
        ((100.0, 800.0, 1600.0, 3200.0), True, True),
        ((800.0, 1600.0), False, False),
    ],
    ids=["a mode far below", "about the ringing", "mostly about it", "a line"],
)
def test_what_lies_far_below_the_ringing_is_no_detail_of_it(
    taken: tuple[float, ...], resembled: bool, detail: bool, wear_rig: Scenario
) -> None:
    before = np.full(BANDS.size, 3.0)
    after = np.where(np.isin(BANDS, taken), 0.0, before)
    runs = cast("tuple[Features, ...]", (SimpleNamespace(band=BANDS), SimpleNamespace(band=BANDS)))
    case = Case(nominal=wear_rig.rig, runs=(), seen=runs, model=model(wear_rig.rig, before), left=())
    first = Trial(Candidate(mechanism="bearing_defect", parts=(STRUCK,), knobs=()), case.model, 1000.0)
    second = Candidate(mechanism="torsional_mode", parts=(), knobs=(), resembled=resembled)
    trial = Trial(second, model(wear_rig.rig, after), 6.5 * len(taken))  # nearly all that their bands miss
    assert bool(details_of_ringing(case, trial, [first])) is detail
    assert details_of_ringing(case, trial, []) == []
