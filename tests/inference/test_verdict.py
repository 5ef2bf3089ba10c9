"""When a nameless effect changes the verdict: its odds reject the model without it."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference.addition import Addition
from torquerig.inference.answer import sizes
from torquerig.inference.answer import verdict as word

EFFECT = Addition(kind="level_course", parts=(SimpleNamespace(name="unnamed_course"),), log_odds=-4.0)


@pytest.mark.parametrize(
    ("evidence", "held_out", "is_evident"),
    [(20.0, 15.0, True), (20.0, 2.0, False), (5.0, 17.0, False), (24.0, -8.0, False)],
)
def test_odds_of_all_data_reject_the_model_without_an_effect(monkeypatch, evidence, held_out, is_evident):
    full, less = (SimpleNamespace(log_evidence=value) for value in (100.0 + evidence, 100.0))
    seen = {id(full): held_out, id(less): 0.0}
    monkeypatch.setattr(word, "refitted", lambda *_, **__: less)
    monkeypatch.setattr(word, "held_out_density", lambda fit, _: seen[id(fit)])
    outcome = SimpleNamespace(model=SimpleNamespace(fit=full), data=None, held=None)
    # 4 nats count for one: 18.4 nats are 1 in 100
    assert word.are_evident(outcome, [EFFECT]) is is_evident


def test_an_effect_that_cannot_be_left_out_says_nothing(monkeypatch):
    monkeypatch.setattr(word, "refitted", lambda *_, **__: None)
    outcome = SimpleNamespace(model=SimpleNamespace(fit=SimpleNamespace(log_evidence=1.0)), data=None, held=None)
    assert not word.are_evident(outcome, [EFFECT])


def test_what_is_large_in_a_quiet_run_is_no_minor_effect(monkeypatch):
    quiet, loud = (SimpleNamespace(run=SimpleNamespace(torque=np.array([-sd, sd]))) for sd in (1.0, 100.0))
    nominal = SimpleNamespace(nominal=SimpleNamespace(part=lambda _: None, measured="sensor"))
    outcome = SimpleNamespace(nominal=nominal, data=SimpleNamespace(seen=(quiet, loud)), runs=(quiet.run, loud.run))
    for own, minor in (((0.1, 0.1), False), ((0.02, 2.0), True), ((0.02, 4.0), False)):
        monkeypatch.setattr(sizes, "_sizes", lambda *_, own=own: iter(own))
        assert sizes.is_minor(outcome, EFFECT) is minor
    assert sizes.relevance(outcome) == pytest.approx(3.0)
