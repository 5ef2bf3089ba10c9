"""Currents turn with the field: a ripple at an order that is no multiple of the pole pairs pays for it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnose.case import Case
from torquerig.diagnose.hypotheses import cogging, commutation_ripple
from torquerig.diagnose.looking.peaks import Peak
from torquerig.diagnose.looking.places import order
from torquerig.scenario.reading import Scenario


@pytest.mark.parametrize(("line", "dearer"), [(42.0, False), (14.0, False), (60.0, True), (36.0, True)])
def test_a_ripple_turns_with_the_field(
    line: float, dearer: bool, wear_rig: Scenario, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The rig's motor has 12 slots and 7 pole pairs; its slots make cogging at 36 and 60, no current does."""
    for hypothesis in (cogging, commutation_ripple):
        monkeypatch.setattr(hypothesis, "line_factor", lambda case, rig, place: 1.0)
    peak = Peak(place=order(line), excess=50.0, runs=("run1",), speeds=1)
    shown = SimpleNamespace(places=(peak.place,), unknown=(peak.place,))
    case: Any = SimpleNamespace(
        left=(peak,), nominal=wear_rig.rig, seen=(shown,), runs=(), model=SimpleNamespace(rig=wear_rig.rig)
    )
    (ripple,) = [each for each in commutation_ripple.propose(cast("Case", case)) if each.place == peak.place]
    assert (ripple.price > 50) is dearer
    if dearer:
        (slots,) = cogging.propose(cast("Case", case))
        assert ripple.price > 10 * slots.price
