"""A number is wrong where the stated one is not adequate, or its odds are clear; else the stated one is kept."""

from __future__ import annotations

from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from torquerig.inference.addition import Addition
from torquerig.inference.answer import stated_numbers, verdict
from torquerig.inference.knobs import Knob

STATED, INERTIA = Knob("controller", "kp", 0.05), Knob("motor", "inertia", 0.1)
NUMBER = Addition(kind="parameter", knobs=(replace(STATED, spread=1.4),), log_odds=-5.0)


@dataclass(frozen=True)
class Model:
    fit: Any
    additions: tuple[Addition, ...]


@dataclass(frozen=True)
class Outcome:
    model: Model
    nominal: Any
    data: Any = None
    held: Any = None


@pytest.mark.parametrize(("odds", "passes", "is_wrong"), [(13.4, True, False), (13.4, False, True), (40.0, True, True)])
def test_a_number_is_kept_where_the_stated_one_fails_or_its_odds_are_clear(monkeypatch, odds, passes, is_wrong):
    fit = SimpleNamespace(
        knobs=(NUMBER.knobs[0], INERTIA), positions=np.array([0.9, 0.3]), rig=None, nominal=None, gains=None, off=None,
        log_evidence=105.0 + odds,
    )  # fmt: skip
    outcome = Outcome(Model(fit, (NUMBER,)), SimpleNamespace(knobs=(STATED, INERTIA)))
    asked = []

    def fitted(_rig, knobs, _data, *, start, **_):
        asked.append((list(knobs), start.tolist()))
        return SimpleNamespace(log_evidence=100.0)

    monkeypatch.setattr(stated_numbers, "far_numbers", lambda _: [NUMBER])
    monkeypatch.setattr(stated_numbers, "fitted", fitted)
    monkeypatch.setattr(stated_numbers, "significant", lambda *_: (() if passes else ("excess",), ()))
    monkeypatch.setattr(verdict, "held_out_density", lambda *_: 0.0)
    found = stated_numbers.with_stated_numbers(outcome)
    assert asked == [([STATED, INERTIA], [0.0, 0.3])]
    assert found.model.additions == ((NUMBER,) if is_wrong else ())
    assert (found.model.fit is fit) is is_wrong
