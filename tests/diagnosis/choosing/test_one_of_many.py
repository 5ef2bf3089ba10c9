"""A small line beside others at whole orders that stay wrong by more may be one of theirs; a large one is not."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.choosing import one_of_many as judging
from torquerig.diagnosis.choosing.one_of_many import one_of_many
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.places import frequency, order
from torquerig.scenario.model import Scenario


def line(at: float, axis: str = "motor_shaft") -> Mismatch:
    return Mismatch(
        domain="order", axis=axis, at=at, width=0.02, recordings=("run1",), excess_dB=20.0, share_of_misfit=0.2,
        p_value=1e-9,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("orders", "gain", "many"),
    [
        ((12.0, 7.0, 21.0), 80.0, True),
        ((12.0, 7.0, 21.0), 900.0, False),
        ((12.0, 7.0), 80.0, False),
        ((12.0, 7.0, 14.0), 80.0, False),
        ((12.3, 7.4, 21.3), 80.0, False),
    ],
    ids=["many", "it took more", "two", "one of them its own", "no whole orders"],
)
def test_a_small_line_among_many_that_stay(
    orders: tuple[float, ...], gain: float, many: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each stays by ten spreads, which count as 54: 2 times 16 times sqrt(1 + 100/16) less one."""
    monkeypatch.setattr(judging, "mismatches", lambda _: tuple(line(at) for at in orders))
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 100.0)
    case = Case(nominal=wear_rig.rig, runs=(), seen=(), model=model, left=())
    ripple = Candidate(mechanism="commutation_ripple", parts=(), knobs=(), place=order(14.0))
    assert one_of_many(case, Trial(ripple, model, gain)) is many
    for place in (None, frequency(50.0)):
        other = Candidate(mechanism="mains_interference", parts=(), knobs=(), place=place)
        assert not one_of_many(case, Trial(other, model, gain))
