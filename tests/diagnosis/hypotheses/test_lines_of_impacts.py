"""What stands at a multiple of a found bearing's order, in each run that shows it, is no tone of fixed frequency."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.hypotheses.fixed_lines import doubtful_lines, fixed_lines
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency, order
from torquerig.mechanisms import BearingDefect
from torquerig.scenario.model import Scenario

RATE, SAMPLES, TURNS = 2000.0, 24_000, 41.9  # of the motor [1/s]


@pytest.mark.parametrize(("impacts", "own"), [(4.42, True), (4.3, False), (None, False)])
def test_they_are_asked_about_only_beside_another_bearing(
    impacts: float | None, own: bool, by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    angle, time = 2 * np.pi * TURNS * np.arange(SAMPLES) / RATE, np.arange(SAMPLES) / RATE
    tone, at_order = 4.42 / 5 * TURNS, 2 * 4.42 / 5
    torque = np.cos(2 * np.pi * tone * time) + np.cos(at_order * angle)
    run = by_hand(torque + 1e-3 * np.random.default_rng(3).standard_normal(SAMPLES), angle, rate=RATE, name="run")
    left = (
        Peak(place=frequency(tone), excess=90.0, runs=("run",), speeds=1),
        Peak(place=order(at_order), excess=90.0, runs=("run",), speeds=1, either=True),
    )
    rig, accepted = wear_rig.rig, tuple[Candidate, ...]()
    if impacts is not None:
        bearing = BearingDefect(name="bearing_defect", order_output=impacts, ring_frequency=900.0, amplitude=0.1)
        rig, accepted = rig + bearing, (Candidate(mechanism="bearing_defect", parts=(bearing,), knobs=()),)
    model = Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    seen = (features(run, [peak.place for peak in left]),)
    case = Case(nominal=wear_rig.rig, runs=(run,), seen=seen, model=model, left=left, accepted=accepted)
    assert (not [*doubtful_lines(case)]) is own
    assert (not fixed_lines(case)) is own
