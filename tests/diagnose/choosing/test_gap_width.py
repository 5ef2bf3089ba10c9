"""A gap's width where nothing can tell it."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnose.case import Case
from torquerig.diagnose.choosing import gap_width
from torquerig.diagnose.fitting.calibration import Calibrated
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize("flying", [False, True])
def test_runs_of_which_none_parts_its_flanks_tell_no_width(
    flying: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A few flights in each of several runs make many together, and no single run one in which flanks may part."""
    monkeypatch.setattr(gap_width, "flanks_fly", lambda _: flying)
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=model, left=(), accepted=())
    assert gap_width.width(case, []) is None
