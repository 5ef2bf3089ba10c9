"""A number is wrong where the stated one is not adequate, or its odds are clear; else the stated one is kept."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from torquerig.inference.addition import Addition
from torquerig.inference.answer import stated_numbers, verdict
from torquerig.inference.knobs import Knob

INERTIA = Knob("motor", "inertia", 0.1)
NUMBER = Addition(kind="parameter", knobs=(Knob("controller", "kp", 1.4),), log_odds=-5.0)


@dataclass(frozen=True)
class Model:
    fit: Any
    additions: tuple[Addition, ...]


@dataclass(frozen=True)
class Outcome:
    model: Model
    data: Any = None
    held: Any = None


@pytest.mark.parametrize(("odds", "passes", "is_wrong"), [(13.4, True, False), (13.4, False, True), (40.0, True, True)])
def test_a_number_is_kept_where_the_stated_one_fails_or_its_odds_are_clear(monkeypatch, odds, passes, is_wrong):
    fit = SimpleNamespace(log_evidence=105.0 + odds)
    outcome = Outcome(Model(fit, (NUMBER,)))
    held = []

    def refitted(_fit, _data, *, keeps):
        held.extend(knob.name for knob in (*NUMBER.knobs, INERTIA) if not keeps(knob))
        return SimpleNamespace(log_evidence=100.0)

    monkeypatch.setattr(stated_numbers, "far_numbers", lambda _: [NUMBER])
    monkeypatch.setattr(stated_numbers, "_holds_stated", lambda *_: False)
    monkeypatch.setattr(stated_numbers, "refitted", refitted)
    monkeypatch.setattr(stated_numbers, "significant", lambda *_: (() if passes else ("excess",), ()))
    monkeypatch.setattr(verdict, "held_out_density", lambda *_: 0.0)
    found = stated_numbers.with_stated_numbers(outcome)
    assert held == ["controller.kp"]
    assert found.model.additions == ((NUMBER,) if is_wrong else ())
    assert (found.model.fit is fit) is is_wrong


@pytest.mark.parametrize(("half", "is_wrong"), [(0.5, True), (3.0, False)])
def test_a_number_whose_interval_holds_the_stated_value_is_never_wrong(monkeypatch, half, is_wrong):
    knob = NUMBER.knobs[0]
    rig = SimpleNamespace(part=lambda _: SimpleNamespace(kp=2.0))
    variance = np.array([[(half / 1.96) ** 2]])
    fit = SimpleNamespace(rig=rig, nominal=rig, knobs=(knob,), positions=np.array([1.0]), covariance=lambda: variance)
    monkeypatch.setattr(stated_numbers, "far_numbers", lambda one: [*one.model.additions])
    monkeypatch.setattr(stated_numbers, "refitted", lambda *_, **__: SimpleNamespace())
    monkeypatch.setattr(stated_numbers, "is_rejected", lambda *_: True)
    found = stated_numbers.with_stated_numbers(Outcome(Model(fit, (NUMBER,))))
    assert found.model.additions == ((NUMBER,) if is_wrong else ())
