"""Of the rigs that a catalog's open counts allow, the one whose model misses clearly least is diagnosed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from torquerig.diagnosis import beginning
from torquerig.diagnosis.beginning import Beginning, begun
from torquerig.diagnosis.case import Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

Record = Callable[..., Recording]


class Reading:
    """A scenario of which only the pole pairs and what its model would be missed by are asked."""

    def __init__(self, pairs: int, missed: float) -> None:
        self.pairs, self.missed = pairs, missed

    def choices(self) -> dict[str, float]:
        return {"motor.pole_pairs": float(self.pairs), "motor.slots": 12.0}


@pytest.mark.parametrize(("missed", "said"), [(10.0, ["motor.pole_pairs = 4 (drawn: 5)"]), (480.0, [])])
def test_the_reading_that_fits_is_taken(
    missed: float, said: list[str], wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Less by 40 than that of the drawn one is no clear sign of another winding."""

    def started(scenario: Any, *_: object) -> Beginning:
        none = np.zeros(0)
        misfits = (Misfit(none, none, np.ones(10)),)
        model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), misfits, scenario.missed)
        case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=model, left=())
        nothing: Any = None
        return Beginning(
            scenario=scenario, whole=wear_rig.rig, own_gap=None, faults=nothing, runs=(), untrue=(), before=case,
            held=(),
        )  # fmt: skip

    monkeypatch.setattr(beginning, "_begun", started)
    drawn: Any = Reading(5, 500.0)
    other: Any = Reading(4, missed)
    start = begun(drawn, [other], (), lambda _: None)
    assert start.scenario is (other if said else drawn)
    assert len(start.remarks) == len(said)
    assert all(each in remark for each, remark in zip(said, start.remarks, strict=True))


@pytest.mark.long
@pytest.mark.parametrize(("costs", "taken"), [((912.0, 491.0), 1), ((491.0, 912.0), 0)])
def test_telegraph_noise_is_judged_at_the_level_that_fits(
    costs: tuple[float, float], taken: int, wear_rig: Scenario, record: Record, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Which of the two levels is the zero the samples do not tell; a model that misses less by one does."""
    runs = [record(wear_rig.rig, 3 + row, rpm=rpm, rate=10_000.0) for row, rpm in enumerate((700.0, 1000.0))]
    flip = np.zeros(runs[0].samples)
    flip[[9_000, 17_000, 17_400, 30_000]] = 1.0
    high = 0.6 * (np.cumsum(flip) % 2)
    spoilt = [each.with_values("torque_V", each.channels["torque_V"].values + high) for each in runs]
    levels: list[float] = []

    def opened(_scenario: Scenario, followed: Any, _nominal: Any, _faults: Any) -> tuple[Case, tuple[()]]:
        levels.append(float(np.mean([run.torque.mean() for run in followed])))
        none = np.zeros(0)
        model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), (), costs[len(levels) - 1])
        return Case(nominal=wear_rig.rig, runs=followed, seen=(), model=model, left=()), ()

    monkeypatch.setattr(beginning, "opened", opened)
    start = begun(wear_rig, (), spoilt, lambda _: None)
    assert levels[1] - levels[0] == pytest.approx(0.6 * start.runs[0].torque_unit, rel=0.03)
    assert np.mean([run.torque.mean() for run in start.runs]) == pytest.approx(levels[taken])
    assert len(start.untrue) >= 2
