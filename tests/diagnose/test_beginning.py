"""Of the rigs that a catalog's open counts allow, the one whose model misses clearly least is diagnosed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from torquerig.diagnose import beginning
from torquerig.diagnose.beginning import Beginning, begun
from torquerig.diagnose.case import Case
from torquerig.diagnose.fitting.calibration import Calibrated
from torquerig.diagnose.fitting.misfit import Misfit
from torquerig.scenario.reading import Scenario


class Reading:
    """A scenario of which only the pole pairs and what its model would be missed by are asked."""

    def __init__(self, pairs: int, missed: float) -> None:
        self.pairs, self.missed = pairs, missed

    def choices(self) -> dict[str, float]:
        return {"motor.pole_pairs": float(self.pairs), "motor.slots": 12.0}


@pytest.mark.parametrize(("missed", "said"), [(10.0, ["motor.pole_pairs 4 (not 5, as drawn)"]), (480.0, [])])
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
