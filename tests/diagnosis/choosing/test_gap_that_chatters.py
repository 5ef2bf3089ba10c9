"""Flanks that chatter and never cross: their spectrum tells that there is a gap, and not how wide it is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import chattering, gap_fits, gap_trial
from torquerig.diagnosis.choosing.chattering import _of_like  # the choice itself, without simulations
from torquerig.diagnosis.choosing.gap_fits import FittedGap, GapFits
from torquerig.diagnosis.choosing.gap_trial import fitted_gap
from torquerig.diagnosis.choosing.opened_gap import ARCMIN, flanks_may_part, opened
from torquerig.diagnosis.engine import diagnose
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import Backlash, Quantization
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

Record = Callable[..., Recording]
GAP = 12 / 60 * pi / 180  # [rad]


@pytest.mark.full
def test_a_gap_is_named_by_the_spectrum_of_its_chatter(known_rig: Scenario, record: Record) -> None:
    rig = known_rig.rig + Backlash(name="hidden", gear="gearbox", gap=GAP)
    runs = [
        record(rig, seed, rpm=rpm, occupancy=occupancy, rate=25_000.0)
        for seed, (rpm, occupancy) in enumerate([(1000, 5), (700, 5), (1000, 0)], start=1)
    ]
    told = diagnose(known_rig, runs).diagnosis
    assert [found.mechanism for found in told.findings] == ["backlash"]
    assert told.verdict == "missing_physics"
    gap = told.findings[0].parameters["gap_arcmin"]
    assert gap.low < 12 < gap.high
    assert gap.high > 3 * gap.low, "no flank crosses, so no width can be told"
    assert told.fit.after < 0.7 * told.fit.before


def test_a_gap_that_nothing_tells_is_none(known_rig: Scenario, monkeypatch: pytest.MonkeyPatch) -> None:
    """Single flights in several runs ask for a gap; where flanks part in none of them, chatter explains nothing."""
    case = Case(nominal=known_rig.rig, runs=(), seen=(), model=_costing(0.0, known_rig), left=())
    monkeypatch.setattr(gap_fits, "calibrated", lambda *_, **__: _costing(0.0, known_rig))
    monkeypatch.setattr(gap_trial, "width", lambda *_: None)
    monkeypatch.setattr(GapFits, "_simulated", lambda *_: ((), []))
    assert fitted_gap(case, known_rig.rig) is None


@pytest.mark.parametrize(
    ("costs", "gap", "within"),
    [
        ([100.0, 99.0, 98.0, 97.5], (1.5 * 45) ** 0.5, (1.5, 45.0)),
        ([200.0, 100.0, 99.0, 150.0], (5 * 15) ** 0.5, (5.0, 15.0)),
        ([200.0, 100.0, 130.0, 150.0], 5.0, None),
    ],
    ids=["any", "two", "one"],
)
def test_the_middle_of_the_widths_that_fit_as_well(
    costs: list[float], gap: float, within: tuple[float, float] | None, known_rig: Scenario
) -> None:
    case = Case(nominal=known_rig.rig, runs=(), seen=(), model=_costing(0.0, known_rig), left=())
    tried = zip((1.5, 5.0, 15.0, 45.0), costs, strict=True)
    best = _of_like(case, [FittedGap(opened(case, each * ARCMIN), _costing(cost, known_rig)) for each, cost in tried])
    assert best.gap / ARCMIN == pytest.approx(gap)
    told = best.candidate.within.get("gap")
    assert (told is None) == (within is None)
    if told is not None and within is not None:
        assert [each / ARCMIN for each in told] == pytest.approx(within)


def _costing(cost: float, scenario: Scenario) -> Calibrated:
    return Calibrated(scenario.rig, (), np.zeros(0), np.zeros((0, 0)), (), cost, ())


@pytest.mark.parametrize(("left", "fits"), [(3.0, 8), (30.0, 4)], ids=["near", "hopeless"])
def test_gaps_whose_chatter_is_far_from_the_recordings_are_fitted_roughly_only(
    left: float, fits: int, known_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    case = Case(nominal=known_rig.rig, runs=(), seen=(), model=_costing(0.0, known_rig), left=())
    made = list[int]()

    def fitted(*_: object, derivatives: int = 0, corrections: object = None, **__: object) -> Calibrated:
        if corrections is not None:
            made.append(derivatives)
        return _costing(0.0, known_rig)

    monkeypatch.setattr(gap_fits, "calibrated", fitted)
    monkeypatch.setattr(chattering, "unexplained", lambda *_: [left])
    monkeypatch.setattr(gap_trial, "width", lambda *_: None)
    monkeypatch.setattr(GapFits, "_simulated", lambda *_: ((), []))
    assert fitted_gap(case, known_rig.rig) is None
    assert len(made) == fits
    assert made[:4] == [1] * 4


@pytest.mark.parametrize(("coarse", "against"), [(False, False), (True, False), (False, True)])
def test_chatter_is_told_beside_other_effects_and_not_under_coarse_codes_nor_against_stays(
    coarse: bool, against: bool, known_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    rig = known_rig.rig + Quantization(name="quantization", step=0.05) if coarse else known_rig.rig
    blades = Candidate(mechanism="blade_pass", parts=(), knobs=())
    case = Case(nominal=rig, runs=(), seen=(), model=_costing(0.0, known_rig), left=(), accepted=(blades,))
    found = FittedGap(opened(case, GAP), _costing(0.0, known_rig))
    monkeypatch.setattr(gap_fits, "calibrated", lambda *_, **__: _costing(0.0, known_rig))
    monkeypatch.setattr(gap_trial, "width", lambda *_: None)
    monkeypatch.setattr(gap_trial, "told_by_chatter", lambda _: found)
    monkeypatch.setattr(GapFits, "_simulated", lambda *_: ((), []))
    monkeypatch.setattr(gap_trial, "stays_speak_against", lambda _: against)
    assert fitted_gap(case, rig) is (None if coarse or against else found)
    alone = replace(case, accepted=())
    assert fitted_gap(alone, rig) is (None if coarse else found), "stays are asked beside what was found before alone"


@pytest.mark.parametrize(("below", "part"), [(0.001, False), (0.005, True)])
def test_flanks_may_part_where_a_few_samples_in_a_thousand_come_near_zero(
    below: float, part: bool, by_hand: Callable[..., Observed]
) -> None:
    torque = np.full(20_000, 0.3)
    torque[:: round(1 / below)] = 0.0
    angle = 80.0 * np.arange(torque.size) / 5000.0
    assert flanks_may_part(features(by_hand(torque, angle), [])) is part
