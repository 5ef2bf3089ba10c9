"""A search whose end is still wrong begins again with the best rival of what it took first."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from torquerig.diagnosis import findings
from torquerig.diagnosis.choosing import beginning_again, chain
from torquerig.diagnosis.choosing.search import Tried
from torquerig.diagnosis.fitting.misfit import Misfit

NONE = Tried((), ())


def trial(name: str, gain: float) -> Any:
    return SimpleNamespace(
        candidate=SimpleNamespace(
            mechanism=name, description="", place=None, slow=name == "drift", knobs=(name,), price=0.0, resembled=False
        ),
        gain=gain, gap=None, beside=(0.0, 0.0),
    )  # fmt: skip


def case_of(names: tuple[str, ...], cost: float) -> Any:
    return SimpleNamespace(names=names, model=SimpleNamespace(cost=cost, misfits=()))


@pytest.fixture
def world(monkeypatch: pytest.MonkeyPatch) -> dict[tuple[str, ...], float]:
    """A mesh that stands in for blades and hum: what each set of effects leaves, and nothing else of a diagnosis."""
    costs = {(): 1000.0, ("mesh",): 500.0, ("blades",): 400.0, ("blades", "hum"): 10.0}

    def trials(case: Any) -> Tried:
        found = [
            trial(name, case.model.cost - costs[(*case.names, name)])
            for name in ("backlash", "mesh", "blades", "hum", "drift", "friction")
            if (*case.names, name) in costs
        ]
        return Tried(tuple(sorted(found, key=lambda one: -one.gain)), ())

    def with_all(start: Any, accepted: Any) -> Any:
        names = tuple(each.trial.candidate.mechanism for each in accepted)
        return case_of(names, costs[names])

    monkeypatch.setattr(chain, "trials", trials)
    monkeypatch.setattr(chain, "with_all", with_all)
    monkeypatch.setattr(chain, "with_gap", lambda accepted, gap: list(accepted))
    monkeypatch.setattr(chain, "_around_gap", lambda case, tried: [])
    monkeypatch.setattr(chain, "revised", lambda start, accepted: tuple(accepted))
    monkeypatch.setattr(chain, "_stands", lambda case, each: True)
    monkeypatch.setattr(findings, "_finding", lambda case, each, held: each.trial.candidate.mechanism)
    monkeypatch.setattr(chain, "_together", lambda start, case, accepted: case.model.cost < 100)
    monkeypatch.setattr(beginning_again, "detail_of", lambda first, case, left: None)
    for module in (chain, beginning_again):
        monkeypatch.setattr(module, "promising", lambda case, each: each.gain > 300)
        monkeypatch.setattr(module, "mismatches", lambda case: () if case.model.cost < 100 else ("somewhere",))
    monkeypatch.setattr(chain, "chatter_outdone", lambda case, each, fitted: False)
    monkeypatch.setattr(chain, "hopeful", lambda case, each: False)
    # blades alone leave the hum, which is too much; a mesh bends until it looks right
    monkeypatch.setattr(chain, "convincing", lambda case, each, **_: each.candidate.mechanism != "blades")
    monkeypatch.setattr(chain, "worthiest", lambda case, found: max(found, key=lambda each: each.gain))
    return costs


def test_the_rival_that_leads_on_takes_the_place_of_the_stand_in(world: dict[tuple[str, ...], float]) -> None:
    found = findings.searched(case_of((), world[()]), (), lambda _: None)
    assert found.findings == ("blades", "hum")


def test_a_rival_that_leads_nowhere_changes_nothing(world: dict[tuple[str, ...], float]) -> None:
    del world["blades", "hum"]
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("mesh",)


def test_a_rival_beside_what_was_taken_first_replaces_nothing(world: dict[tuple[str, ...], float]) -> None:
    """It was asked as an addition already, and did not convince."""
    del world["blades", "hum"]
    world["blades", "mesh"] = 10.0
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("mesh",)


def test_a_rival_that_leaves_nearly_as_much_replaces_nothing(
    world: dict[tuple[str, ...], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(chain, "_together", lambda start, case, accepted: True)
    world["blades", "hum"] = 300.0
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("mesh",)


def test_where_what_was_taken_first_falls_its_rival_is_asked_too(
    world: dict[tuple[str, ...], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(chain, "_stands", lambda case, each: each.trial.candidate.mechanism != "mesh")
    monkeypatch.setattr(chain, "rest_of", lambda case, each: 9.0)
    monkeypatch.setattr(chain, "only", lambda start, accepted, gone: (start, []))
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("blades", "hum")


def test_details_of_a_strong_effect_are_no_reason(
    world: dict[tuple[str, ...], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(beginning_again, "detail_of", lambda first, case, left: 1e-3)
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("mesh",)


def test_what_is_right_is_not_begun_again(world: dict[tuple[str, ...], float]) -> None:
    world["mesh",] = 50.0
    said: list[str] = []
    assert findings.searched(case_of((), world[()]), (), said.append).findings == ("mesh",)
    assert not any("restarting the search" in each for each in said)


@pytest.mark.parametrize(("pair", "names"), [(40.0, ("mesh", "hum")), (60.0, ("backlash", "mesh"))])
def test_a_gap_and_half_of_a_pair_give_way_to_the_pair_that_misses_less(
    pair: float, names: tuple[str, ...], world: dict[tuple[str, ...], float]
) -> None:
    """Nothing is left of either; a gap bends with every line, so that it hides what the hum does."""
    world.clear()
    world.update(
        {(): 1000.0, ("backlash",): 300.0, ("mesh",): 500.0, ("backlash", "mesh"): 50.0, ("mesh", "hum"): pair}
    )
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == names


@pytest.mark.parametrize(("left", "share", "right"), [((), 0.7, True), (("a",), 0.7, False), (("a",), 0.9, True)])
def test_two_that_leave_nothing_standing_out_may_explain_less(
    left: tuple[str, ...], share: float, right: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    def of(residual: float) -> Any:
        return SimpleNamespace(model=SimpleNamespace(misfits=[Misfit(np.zeros(0), np.zeros(0), np.full(40, residual))]))

    monkeypatch.setattr(chain, "mismatches", lambda case: left)
    before, after = 3.9, float(np.sqrt(1 + (1 - share) * (3.9**2 - 1)))
    assert chain._together(of(before), of(after), ()) is right


@pytest.mark.parametrize("second", [True, False])
def test_two_that_hide_each_other_are_found_together_or_not_at_all(
    second: bool, world: dict[tuple[str, ...], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Blades explain their places and convince nobody while the hum is there; alone they stay unconvincing."""
    world.clear()
    world.update({(): 1000.0, ("blades",): 950.0})
    if second:
        world["blades", "hum"] = 10.0
    monkeypatch.setattr(chain, "hopeful", lambda case, each: each.candidate.mechanism == "blades")
    monkeypatch.setattr(chain, "_together", lambda start, case, accepted: True)
    found = findings.searched(case_of((), world[()]), (), lambda _: None).findings
    assert found == (("blades", "hum") if second else ())


def test_what_the_first_beginning_found_is_kept_beside_what_took_its_place(
    world: dict[tuple[str, ...], float],
) -> None:
    found = findings.searched(case_of((), world[()]), (), lambda _: None)
    assert found.instead is not None
    assert found.instead.findings == ("mesh",)
    del world["blades", "hum"]
    assert findings.searched(case_of((), world[()]), (), lambda _: None).instead is None


def test_a_rival_that_leads_to_what_was_taken_first_is_followed_no_further(
    world: dict[tuple[str, ...], float], monkeypatch: pytest.MonkeyPatch
) -> None:
    del world["blades", "hum"]
    world["blades", "mesh"] = 200.0
    tried, asked = chain.trials, list[tuple[str, ...]]()

    def counted(case: Any) -> Tried:
        asked.append(case.names)
        return tried(case)

    monkeypatch.setattr(chain, "trials", counted)
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == ("mesh",)
    assert asked == [(), ("mesh",), ("blades",)]


@pytest.mark.parametrize("hum", [None, 500.0, 390.0], ids=["", "beside a hum", "beside a hum that gains more"])
@pytest.mark.parametrize(("left", "found"), [(10.0, ("drift", "friction")), (200.0, ())], ids=["right", "still wrong"])
def test_a_drift_whose_levels_a_friction_bends_is_half_of_a_pair_that_leaves_nothing(
    left: float, found: tuple[str, ...], hum: float | None, world: dict[tuple[str, ...], float],
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    """The friction alone is none that can be, since the drift bends it; and the drift alone leaves its levels wrong.

    Where half of another pair gains more, that one is asked alone.
    """
    world.clear()
    world.update({(): 1000.0, ("drift",): 400.0, ("drift", "friction"): left})
    world.update({} if hum is None else {("hum",): hum})
    found = () if hum is not None and hum < 400.0 else found
    for module in (chain, beginning_again):
        monkeypatch.setattr(module, "promising", lambda case, each: each.candidate.mechanism == "hum")
        monkeypatch.setattr(module, "takes_much", lambda case, each: each.gain > 300)
    monkeypatch.setattr(chain, "_together", lambda start, case, accepted: len(accepted) > 1)
    monkeypatch.setattr(chain, "convincing", lambda case, each, **_: each.candidate.mechanism == "friction")
    monkeypatch.setattr(chain, "small_beside", lambda trial, earlier: False)
    assert findings.searched(case_of((), world[()]), (), lambda _: None).findings == found
