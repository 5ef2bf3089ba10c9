"""A tone at the frequency of a grid is the grid's, not an alias that happens to fall there."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import pwm_aliasing
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency


@pytest.mark.parametrize(("tone", "proposed"), [(49.98, False), (60.05, False), (50.4, True), (777.0, True)])
def test_an_alias_is_proposed_beside_the_grid_alone(
    tone: float, proposed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    line = Peak(place=frequency(tone), excess=100.0, runs=("run1",), speeds=1, either=True)
    monkeypatch.setattr(pwm_aliasing, "fixed_lines", lambda case: [line])
    monkeypatch.setattr(pwm_aliasing, "doubtful_lines", lambda case: [line])
    monkeypatch.setattr(pwm_aliasing, "mechanical_range", lambda case: 500.0)
    found: list[Any] = list(pwm_aliasing.propose(cast("Case", SimpleNamespace())))
    assert [each.place.at for each in found] == ([tone] if proposed else [])
