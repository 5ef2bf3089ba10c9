"""An effect that leaves most of what was missed, beside a model that stays wrong, is not told; a large one is."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from torquerig.diagnosis.motion import believed as room
from torquerig.diagnosis.motion.tried import Step


def told(monkeypatch: pytest.MonkeyPatch, *, before: float, after: float, wrong: bool) -> tuple[Any, Any]:
    models = {"before": before, "after": after}
    monkeypatch.setattr(room, "relative_error", lambda model, runs: models[model])
    monkeypatch.setattr(room, "mismatches", lambda model, runs, before: ("a place",) if wrong else ())
    monkeypatch.setattr(room, "at_their_ends", lambda model, of: ())
    named = SimpleNamespace(model=SimpleNamespace(), candidate=SimpleNamespace(mechanism="stribeck_friction"))
    named.model = "after"
    step = cast("Step", SimpleNamespace(kept=named))
    first = cast("Any", type("Before", (str,), {"knobs": ()})("before"))
    return room.believed(first, (step,), (), ())


@pytest.mark.parametrize(("after", "wrong", "kept"), [(0.084, True, 0), (0.084, False, 1), (0.03, True, 1)])
def test_what_hardly_helps_is_told_only_where_all_is_right(
    after: float, wrong: bool, kept: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    steps, refused = told(monkeypatch, before=0.096, after=after, wrong=wrong)
    assert (len(steps), len(refused)) == (kept, 1 - kept)
    assert all("hardly improves the prediction" in each.why for each in refused)


def test_nothing_found_is_nothing_refused() -> None:
    assert room.believed(cast("Any", "before"), (), (), ()) == ((), ())
