"""What no fit has seen must not be predicted worse with what was found: all of it is withdrawn then, and said."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis import findings
from torquerig.diagnosis.choosing.search import Tried
from torquerig.diagnosis.findings import Searched, reasons
from torquerig.diagnosis.outcome import Finding


def test_a_withdrawn_effect_is_told_among_what_was_set_aside(monkeypatch: pytest.MonkeyPatch) -> None:
    before, after = cast(Any, SimpleNamespace(name="before")), cast(Any, SimpleNamespace(name="after"))
    friction = cast(Finding, SimpleNamespace(mechanism="stribeck_friction", alternatives=()))
    first, last = Tried((), ()), Tried((), ())
    found = Searched(case=after, findings=(friction,), descriptions=("noise",), first=first, last=last)
    assert list(found.in_turn(before, ())) == [found], "nothing of its own to withdraw"
    withdrawn = found.all_withdrawn(before)
    assert withdrawn.case is before
    assert withdrawn.findings == withdrawn.descriptions == ()
    assert withdrawn.last is first  # what would tell is asked of the model without it

    def aside(case: Any, tried: Tried, *, known: list[str]) -> dict[str, str]:
        return {name: "tried" for name in ("cogging", "stribeck_friction") if name not in known}

    monkeypatch.setattr(findings, "set_aside", aside)
    told = reasons(before, withdrawn, (), why="fitted, then rejected")
    assert "rejected" in told["stribeck_friction"]
    assert told["cogging"] == "tried"
    assert reasons(before, found, (friction,), why="") == {"cogging": "tried"}


@pytest.mark.parametrize("gains", [True, False])
def test_before_all_is_withdrawn_the_numbers_are_held(gains: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    before, after, held_fast = (cast(Any, SimpleNamespace(name=name)) for name in ("before", "after", "held"))
    tried, found = Tried((), ()), cast(Any, SimpleNamespace(trial=SimpleNamespace(candidate=SimpleNamespace())))
    found.trial.candidate.description = ""
    monkeypatch.setattr(findings, "with_numbers_held", lambda case, its: held_fast if gains else None)
    monkeypatch.setattr(findings, "_finding", lambda final, accepted, held: SimpleNamespace(mechanism=final.name))
    first = Searched(
        case=after, findings=(cast(Any, SimpleNamespace(mechanism="drag")),), descriptions=(), first=tried, last=tried,
        accepted=(found,),
    )  # fmt: skip
    cases = [each.case for each in first.in_turn(before, ())]
    assert cases == ([after, held_fast, before] if gains else [after, before])
    *_, last = first.in_turn(before, ())
    assert last.withdrawn == ("drag",)
    assert last.findings == last.accepted == ()
    other = replace(first, case=cast(Any, SimpleNamespace(name="other")))
    turns = [(each.case, each.numbers_held) for each in replace(first, instead=other).in_turn(before, ())]
    assert turns == [(after, False), *([(held_fast, True)] if gains else []), (other.case, False), (before, False)]


def test_lines_alone_are_asked_again_beside_numbers_that_stand_still() -> None:
    """With a line others may have moved that it does not explain; a drag that leaves a rest leaves it anyhow."""
    line, drag = (SimpleNamespace(trial=SimpleNamespace(candidate=SimpleNamespace(place=at))) for at in (1, None))
    found = Searched(case=cast(Any, None), findings=(), descriptions=(), first=Tried((), ()), last=Tried((), ()))
    assert [replace(found, accepted=cast(Any, each)).all_lines for each in ((line,), (line, drag))] == [True, False]
