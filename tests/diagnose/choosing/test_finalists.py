"""Which hypotheses are fitted with all numbers free: the promising, and what moves the slow torque alike."""

from __future__ import annotations

from typing import Any, cast

import pytest

from torquerig.diagnose.case import SLOW_TORQUE, Candidate
from torquerig.diagnose.choosing.search import Trial, _finalists


def trial(name: str, gain: float, *, slow: bool = False) -> Trial:
    loosens = SLOW_TORQUE if slow else ()
    candidate = Candidate(mechanism=name, parts=(), knobs=(), loosens=loosens)
    return Trial(candidate, cast(Any, None), gain)


@pytest.mark.parametrize(("drag", "named"), [(10.0, ["sensor_drift", "quadratic_drag"]), (-1.0, ["sensor_drift"])])
def test_slow_rivals_of_a_slow_effect_are_always_fitted(drag: float, named: list[str]) -> None:
    """Friction and load have taken their part of a drag: what is left looks small until they are free."""
    screened = [trial("sensor_drift", 80.0, slow=True), trial("quadratic_drag", drag, slow=True), trial("hump", 4.0)]
    assert [each.candidate.mechanism for each in _finalists(screened)] == named


def test_beside_a_line_small_gains_are_not_fitted() -> None:
    screened = [trial("gear_mesh", 80.0), trial("cogging", 30.0), trial("quadratic_drag", 10.0, slow=True)]
    assert [each.candidate.mechanism for each in _finalists(screened)] == ["gear_mesh", "cogging"]
    assert _finalists([trial("gear_mesh", -5.0)]) == []


def test_slow_ones_do_not_crowd_out_a_line() -> None:
    """A bent slow torque lets all of its rivals gain; blades, which bent it, are seen by their line alone so far."""
    slow = [trial(f"slow {row}", 250.0 - row, slow=True) for row in range(6)]
    lines = [trial(f"line {row}", 140.0 - row) for row in range(4)]
    named = [each.candidate.mechanism for each in _finalists([*slow, *lines])]
    assert named == [f"slow {row}" for row in range(5)] + ["line 0", "line 1"]
