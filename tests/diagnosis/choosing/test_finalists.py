"""Which hypotheses are fitted with all numbers free: the promising, what moves the slow torque alike, the absorbed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from torquerig.diagnosis.case import SLOW_TORQUE, Candidate
from torquerig.diagnosis.choosing import screening
from torquerig.diagnosis.choosing.screening import finalists
from torquerig.diagnosis.choosing.trial import Trial
from torquerig.inference.places import order


@dataclass
class Held:
    """What of a model the screening asks."""

    rig: str


def trial(name: str, gain: float, *, slow: bool = False, at: float | None = None) -> Trial:
    loosens = SLOW_TORQUE if slow else ()
    place = None if at is None else order(at)
    candidate = Candidate(mechanism=name, parts=(), knobs=(), loosens=loosens, place=place)
    return Trial(candidate, cast(Any, None), gain)


@pytest.mark.parametrize(("drag", "named"), [(10.0, ["sensor_drift", "quadratic_drag"]), (-1.0, ["sensor_drift"])])
def test_slow_rivals_of_a_slow_effect_are_always_fitted(drag: float, named: list[str]) -> None:
    """Friction and load have taken their part of a drag: what is left looks small until they are free."""
    screened = [trial("sensor_drift", 80.0, slow=True), trial("quadratic_drag", drag, slow=True), trial("hump", 4.0)]
    assert [each.candidate.mechanism for each in finalists(screened)] == named


def test_beside_a_line_small_gains_are_not_fitted() -> None:
    screened = [trial("gear_mesh", 80.0), trial("cogging", 30.0), trial("quadratic_drag", 10.0, slow=True)]
    assert [each.candidate.mechanism for each in finalists(screened)] == ["gear_mesh", "cogging"]
    assert finalists([trial("gear_mesh", -5.0)]) == []


@pytest.mark.parametrize(("gain", "at", "fitted"), [(-3.4, 84.0, True), (-25.0, 84.0, False), (-3.4, 42.0, False)])
def test_a_close_rival_of_a_line_is_fitted_with_it(gain: float, at: float, fitted: bool) -> None:
    """The numbers that the line has bent decide between them, and stand still while hypotheses are screened."""
    screened = [trial("mode", 7.3), trial("cogging", 5.9, at=84.0), trial("ripple", gain, at=at)]
    named = [each.candidate.mechanism for each in finalists(screened)]
    assert named == ["mode", "cogging", *["ripple"] * fitted]


def test_slow_ones_do_not_crowd_out_a_line() -> None:
    """A bent slow torque lets all of its rivals gain; blades, which bent it, are seen by their line alone so far."""
    slow = [trial(f"slow {row}", 250.0 - row, slow=True) for row in range(6)]
    lines = [trial(f"line {row}", 140.0 - row) for row in range(4)]
    named = [each.candidate.mechanism for each in finalists([*slow, *lines])]
    assert named == [f"slow {row}" for row in range(5)] + ["line 0", "line 1"]


def test_what_the_numbers_stood_in_for_is_fitted_once_they_give_way(monkeypatch: pytest.MonkeyPatch) -> None:
    """A heavy mode passes for inertia: with the model held it fits worse, with its numbers free far better."""
    costs = {"model": 900.0, "heavy": 800.0, "light": 860.0, "little": 890.0}
    monkeypatch.setattr(screening, "profiled_cost", lambda model, rig, seen: costs[rig])
    model = Held("model")
    case = cast(Any, SimpleNamespace(model=model, seen=(), beginnings=lambda: (model,)))

    def tried(mechanism: str, rig: str, *, promised: float = 10.0) -> Trial:
        candidate = SimpleNamespace(
            mechanism=mechanism, promised=promised, knobs=(1,), price=0.0, added_to=lambda _: rig
        )  # fmt: skip
        return Trial(cast(Any, candidate), cast(Any, None), -7.0)

    (found,) = screening.given_way_to(case, [tried("mode", "light"), tried("mode", "heavy"), tried("branch", "little")])
    assert (found.model.rig, found.gain) == ("heavy", 100.0 - screening.PER_KNOB)
    assert screening.given_way_to(case, [tried("bandwidth", "heavy", promised=math.inf)]) == []
    assert screening.given_way_to(case, [tried("bandwidth", "light", promised=40.0)]) == []
    (low_pass,) = screening.given_way_to(case, [tried("bandwidth", "heavy", promised=40.0)])
    assert low_pass.model.rig == "heavy"


def test_numbers_bent_too_far_to_come_back_are_begun_as_the_scenario_has_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Stiffness and inertia that stand in for a low-pass lie so far off that their derivatives lead nowhere."""
    costs = {"model": 900.0, "model + low-pass": 1500.0, "scenario + low-pass": 700.0}
    monkeypatch.setattr(screening, "profiled_cost", lambda model, rig, seen: costs[rig])
    model = Held("model")
    case = cast(Any, SimpleNamespace(model=model, seen=(), beginnings=lambda: (model, Held("scenario"))))
    candidate = SimpleNamespace(
        mechanism="bandwidth", promised=40.0, knobs=(1,), price=0.0, added_to=lambda rig: f"{rig} + low-pass"
    )
    (found,) = screening.given_way_to(case, [Trial(cast(Any, candidate), cast(Any, None), -7.0)])
    assert (found.model.rig, found.gain) == ("scenario + low-pass", 200.0 - screening.PER_KNOB)


@pytest.mark.parametrize(("viscous", "asked"), [(5.0, True), (1.0, False)])
def test_what_the_scenarios_numbers_stood_in_for_is_begun_as_it_was_proposed(
    viscous: float, asked: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Friction bent by five of its spreads may be a drag; where drag is fitted anyway, or none is bent, no more."""
    monkeypatch.setattr(screening, "replace", lambda held, **changes: SimpleNamespace(**{**vars(held), **changes}))
    monkeypatch.setattr(screening, "turned", lambda rig, knobs, positions: (rig, positions.tolist()))
    knobs = (SimpleNamespace(part="wear_part", field="viscous"), SimpleNamespace(part="drift", field="span"))
    model = SimpleNamespace(knobs=knobs, positions=np.array([viscous, 2.0]), rig="fitted")
    found = SimpleNamespace(parts=(SimpleNamespace(name="drift"),))
    case = cast(Any, SimpleNamespace(model=model, accepted=(found,), nominal_with_accepted=lambda: "scenario"))
    candidate = SimpleNamespace(mechanism="drag", loosens=SLOW_TORQUE, added_to=lambda rig: (rig, "drag"))
    drag = cast(Any, SimpleNamespace(candidate=candidate, gain=-3.0))
    begun = screening.stood_in_for(case, [drag], [])
    assert [each.model.rig for each in begun] == [(("scenario", [0.0, 2.0]), "drag")] * asked
    assert screening.stood_in_for(case, [drag], [drag]) == []
