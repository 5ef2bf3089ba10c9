"""Places at which a model still differs: the largest residuals of a kind that are not neighbours."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.addition import Addition
from torquerig.inference.adequacy import Excess, judged_run
from torquerig.inference.answer import located
from torquerig.inference.answer.located import _peaks, differences
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.features.run_features import run_features
from torquerig.inference.likelihood import BAND, LEVEL, Residuals
from torquerig.inference.places import Place


@pytest.mark.parametrize("kind", [LEVEL, BAND])
def test_neighbours_and_small_residuals_are_no_places(kind):
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    shown = np.arange(seen.level.size) if kind == LEVEL else np.flatnonzero(np.isfinite(seen.band_power[0]))[:16]
    value = np.zeros(shown.size)
    value[1], value[2], value[11], value[15] = 10.0, 9.0, -8.0, 4.0
    segment = np.full(shown.size, -1 if kind == LEVEL else 0)
    each = Residuals(value, np.ones(shown.size), np.full(shown.size, kind, dtype=np.int8), shown, segment)
    first = Excess("largest", 1e-9, 0, kind, 1, 1.0)
    assert [one.row for one in _peaks([judged_run(seen, each)], first)] == [1, 11]


def test_a_line_at_one_speed_is_reported_in_both_domains(monkeypatch):
    order, tone = Place("order", 3.3), Place("frequency", 66.0)
    found = (FoundLine(tone, -40.0, -39.0, order), FoundLine(order, -39.0, -40.0, tone))
    monkeypatch.setattr(located, "all_residuals", lambda *_: [])
    monkeypatch.setattr(located, "_is_open", lambda *_: False)
    fit = SimpleNamespace(expected=(), gains=None, off=None)
    for mechanism, places in (("", [tone, order]), ("mains_interference", [tone])):
        model = SimpleNamespace(additions=(Addition(mechanism=mechanism, kind="tone", places=(tone,)),))
        outcome = SimpleNamespace(nominal=fit, model=model, data=SimpleNamespace(seen=()), found=found)
        rows = differences(outcome)
        assert {(row["domain"], row["at"]) for row in rows} == {(place.domain, place.at) for place in places}


def test_a_line_that_no_addition_explains_is_a_place(monkeypatch):
    monkeypatch.setattr(located, "all_residuals", lambda *_: [])
    monkeypatch.setattr(located, "_is_open", lambda _, place: place.at < 60)
    found = tuple(FoundLine(Place("frequency", at), -at, 0.0) for at in (70.0, 41.5))
    fit = SimpleNamespace(expected=(), gains=None, off=None)
    outcome = SimpleNamespace(
        nominal=fit, model=SimpleNamespace(additions=()), data=SimpleNamespace(seen=()), found=found
    )  # fmt: skip
    (row,) = differences(outcome)
    assert (row["domain"], row["at"], row["p_value"]) == ("frequency", 41.5, pytest.approx(np.exp(-41.5), rel=1e-4))


@pytest.mark.parametrize(
    ("at", "is_lacking", "is_open"), [(50.0, True, True), (50.0, False, False), (1.3, False, True)]
)
def test_a_line_is_open_that_the_model_lacks_or_no_block_can_show(monkeypatch, at, is_lacking, is_open):
    seen = run_features(drawn_run(1, speed=steady(1000, duration=6.0)), [Place("frequency", at)])
    monkeypatch.setattr(located, "lacks", lambda *_: is_lacking)
    outcome = SimpleNamespace(nominal=None, data=SimpleNamespace(seen=(seen,)))
    assert located._is_open(outcome, Place("frequency", at)) is is_open


@pytest.mark.parametrize(("axis", "at"), [("level", -4.0), ("speed", 50.0 * 0.25 * 30 / np.pi)])
def test_a_place_over_a_quantity_has_a_width_also_where_torque_or_shaft_turn_back(monkeypatch, axis, at):
    monkeypatch.setattr(located, "effort_unit", lambda _: "N*m")
    monkeypatch.setattr(located, "shafts_of", lambda _: [SimpleNamespace(turns=1.0), SimpleNamespace(turns=-0.25)])
    seen = SimpleNamespace(level=np.array([-4.0]), level_speed=np.array([[-50.0, -50.0]]))
    found = located._over(SimpleNamespace(completed=None), seen, 0, axis)
    assert found["at"] == pytest.approx(at, rel=1e-4)
    assert found["width"] == pytest.approx(0.1 * abs(at), rel=1e-4)
