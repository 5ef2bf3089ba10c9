"""A gap's width where nothing can tell it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.choosing import gap_width
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.scenario.model import Scenario


@pytest.mark.parametrize("flying", [False, True])
def test_runs_of_which_none_parts_its_flanks_tell_no_width(
    flying: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A few flights in each of several runs make many together, and no single run one in which flanks may part."""
    monkeypatch.setattr(gap_width, "flanks_fly", lambda _: flying)
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=model, left=(), accepted=())
    assert gap_width.width(gap_width.WithGaps(case, [])) is None


@pytest.mark.parametrize(
    ("beside_gaps", "against"), [(30.0, True), (0.15, False)], ids=["none is as seen", "some is nearly as seen"]
)
def test_stays_as_without_a_gap_speak_against_any_that_would_change_them(beside_gaps: float, against: bool) -> None:
    seen, closed, parted = (SimpleNamespace(stays=np.full(5, level)) for level in (0.0, 0.1, beside_gaps))
    shown = SimpleNamespace(rigs=[object()], told=[seen], closed=[closed], opened=[[parted]] * gap_width._GAPS.size)
    assert gap_width.stays_speak_against(cast("gap_width.WithGaps", shown)) is against
    none = SimpleNamespace(rigs=[], told=[], closed=[], opened=[])
    assert not gap_width.stays_speak_against(cast("gap_width.WithGaps", none))
