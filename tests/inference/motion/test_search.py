"""Which proposal a round accepts."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from torquerig.inference.motion import search
from torquerig.inference.motion.hypothesis import Hypothesis


def tried(name: str, *, odds: float, density: float, square: float) -> Any:
    fit = SimpleNamespace(log_odds=odds, model=None, density=density, square=square)
    return search.Tried(Hypothesis(name=name, label=name), fit)  # type: ignore[arg-type]


def test_refused_forms_of_one_effect_do_not_hide_the_next_effect(monkeypatch: pytest.MonkeyPatch) -> None:
    """Four forms of a line, all refused by the held-out rms, are ahead of an effect that passes."""
    monkeypatch.setattr(search, "fitted", lambda *_, **__: None)
    monkeypatch.setattr(
        search, "held_out", lambda fit: SimpleNamespace(log_density=fit.density, square=fit.square)
    )  # fmt: skip
    now: Any = SimpleNamespace(log_odds=0.0, runs=(), density=0.0, square=1.0)
    forms = [tried(f"line {form}", odds=50.0 - form, density=20.0, square=1.5) for form in range(4)]
    passing = tried("over_speed", odds=20.0, density=10.0, square=0.5)
    step = search._accepted(now, [*forms, passing])
    assert step is not None
    assert step.kept.hypothesis.name == "over_speed"
    assert search._accepted(now, forms) is None


def test_the_form_of_an_effect_is_the_one_that_predicts_in_newton_metres() -> None:
    """By direction a line has free sizes in a direction that no fit has seen: more likely, and no prediction."""
    forms = [tried("line", odds=50.0, density=density, square=square) for density, square in ((20.0, 1.8), (5.0, 1.0))]
    other = tried("tone", odds=40.0, density=0.0, square=0.9)
    of_each = tried("line", odds=49.0, density=0.0, square=0.7)  # its sizes are those of the held-out run
    forms.append(replace(of_each, hypothesis=replace(of_each.hypothesis, local=True)))
    judged: Any = [
        (one, SimpleNamespace(log_density=one.fit.density, square=one.fit.square)) for one in (*forms, other)
    ]
    assert search._best(judged) is forms[1]


def test_held_out_data_count_against_an_alternative_and_not_for_it() -> None:
    kept, worse, free = (tried(name, odds=odds, density=0.0, square=1.0) for name, odds in
                         (("friction", 50.0), ("mode", 52.0), ("line by direction", 20.0)))  # fmt: skip
    density = {id(kept): 0.0, id(worse): -30.0, id(free): 100.0}
    assert [search._gap(kept, other, density) for other in (worse, free)] == [28.0, 30.0]


@pytest.mark.parametrize(("square", "kept"), [(0.3, "friction"), (0.6, "course")])
def test_a_mechanism_that_predicts_most_is_not_replaced_by_sizes_of_each_run(
    monkeypatch: pytest.MonkeyPatch, square: float, kept: str
) -> None:
    """A course that each run must be given is likelier than any law and says nothing about the next run."""
    monkeypatch.setattr(search, "held_out", lambda fit: SimpleNamespace(log_density=fit.density, square=fit.square))
    friction = Hypothesis(name="friction", label="friction", mechanism="stribeck_friction")
    course = tried("course", odds=90.0, density=40.0, square=0.1)
    course = replace(course, hypothesis=replace(course.hypothesis, local=True))
    monkeypatch.setattr(search, "_tried", lambda _: iter([course]))
    model: Any = SimpleNamespace(minus=lambda _: None, additions=())
    less: Any = SimpleNamespace(log_odds=0.0, model=model, density=0.0, square=1.0)
    monkeypatch.setattr(search, "fitted", lambda made, *_, **__: less if made is None else None)
    fit: Any = SimpleNamespace(log_odds=50.0, model=model, runs=(), density=20.0, square=square)
    course.fit.model = model
    _, step = search._in_place(fit, friction)
    assert step.kept.hypothesis.name == kept
