"""A low harmonic of the grid is the grid's, and a comb of a slow rhythm is something's that moves."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.hypotheses import pwm_aliasing
from torquerig.diagnosis.looking.peaks import Peak
from torquerig.inference.places import frequency


@pytest.fixture
def proposed(monkeypatch: pytest.MonkeyPatch) -> Any:
    """Frequencies [Hz] of the tones of each candidate for left lines at these, all above what the shafts pass on."""
    monkeypatch.setattr(pwm_aliasing, "mechanical_range", lambda case: 0.1)
    monkeypatch.setattr(pwm_aliasing, "doubtful_lines", lambda case: ())

    def of(*at: float) -> list[list[float]]:
        peaks = [Peak(place=frequency(each), excess=50.0, runs=("a", "b"), speeds=2) for each in at]
        monkeypatch.setattr(pwm_aliasing, "fixed_lines", lambda case: peaks)
        candidates = pwm_aliasing.propose(cast("Case", SimpleNamespace()))
        return [[cast(Any, part).frequency for part in each.parts] for each in candidates]

    return of


@pytest.mark.parametrize(
    ("at", "switching"), [(249.85, False), (150.1, False), (299.9, False), (200.0, True), (249.0, True), (4711.0, True)]
)
def test_a_low_harmonic_of_the_grid_is_the_grid_s(at: float, switching: bool, proposed: Any) -> None:
    assert (proposed(at) == [[at]]) is switching


def test_a_comb_is_of_a_rhythm_that_nothing_slow_has(proposed: Any) -> None:
    assert [280.0, 560.0, 840.0] in proposed(280.0, 560.0, 840.0)
    assert all(len(each) == 1 for each in proposed(3.55, 7.1, 10.65, 14.2))


def test_a_tone_at_an_order_pays_for_the_chance_that_put_it_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pwm_aliasing, "mechanical_range", lambda case: 500.0)
    ordered, above = (Peak(place=frequency(at), excess=50.0, runs=("a",), speeds=1) for at in (98.415, 4711.0))
    monkeypatch.setattr(pwm_aliasing, "fixed_lines", lambda case: [ordered, above])
    monkeypatch.setattr(pwm_aliasing, "doubtful_lines", lambda case: [ordered])
    prices = {each.place: each.price for each in pwm_aliasing.propose(cast("Case", SimpleNamespace()))}
    assert prices[above.place] == 0.0
    assert prices[ordered.place] == pytest.approx(7.82, abs=0.01)  # one in fifty
