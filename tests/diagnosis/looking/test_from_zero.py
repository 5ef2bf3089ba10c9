"""A zero that has drifted hides where flanks part, until the drift is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing.opened_gap import flanks_fly, flanks_may_part
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.from_zero import from_zero, undrifted, without_drift
from torquerig.diagnosis.looking.observed import Observed
from torquerig.mechanisms import Backlash, SensorDrift
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

RATE, SPEED = 25_000.0, 80.0
DRIFT = SensorDrift(name="sensor_drift", span=1.5, time_constant=0.8)
Record = Callable[..., Recording]
ByHand = Callable[..., Observed]


@pytest.mark.parametrize("drift", [DRIFT, replace(DRIFT, time_constant=None)], ids=["exponential", "linear"])
def test_a_recording_is_what_it_was_without_its_drift(
    drift: SensorDrift, wear_rig: Scenario, record: Record, by_hand: ByHand
) -> None:
    """Made by the simulator and not by what takes it out, but for half a step of the converter, each way."""
    still, drifting = (record(rig, 1, duration=2.0) for rig in (wear_rig.rig, wear_rig.rig + drift))
    angle = SPEED * still.time()
    shifted, straight = (replace(by_hand(one.torque(), angle), recording=one) for one in (drifting, still))
    assert np.abs(shifted.torque - straight.torque).max() > 1.0
    assert undrifted(shifted, wear_rig.rig + drift).torque == pytest.approx(straight.torque, abs=1e-3)
    assert without_drift(wear_rig.rig + drift) == wear_rig.rig


def test_flanks_part_where_the_torque_without_its_drift_is_zero(
    wear_rig: Scenario, record: Record, by_hand: ByHand
) -> None:
    rig = wear_rig.rig + Backlash(name="backlash", gear="gearbox", gap=15 / 60 * pi / 180)
    made = record(rig + DRIFT, 1, rpm=400.0, occupancy=0.0, rate=RATE)
    run = replace(by_hand(made.torque(), SPEED / 2 * made.time(), rate=RATE), recording=made)
    case = _case(wear_rig, run)
    assert not flanks_may_part(case.from_zero[0])
    assert not flanks_fly(case)
    known = replace(case, model=replace(case.model, rig=wear_rig.rig + DRIFT))
    assert flanks_may_part(known.from_zero[0])
    assert from_zero(case.seen[0], wear_rig.rig) is case.seen[0]
    slipping = _case(wear_rig, replace(run, slipping=True))
    drifting = replace(slipping, model=known.model)
    assert not flanks_may_part(drifting.from_zero[0]), "what slips strikes as they do"
    assert not flanks_fly(drifting)


def _case(scenario: Scenario, run: Observed) -> Case:
    model = Calibrated(scenario.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    return Case(nominal=scenario.rig, runs=(run,), seen=(features(run, []),), model=model, left=())
