"""Which of the fitted additions of a round is taken: the likeliest given fitted and held-out data."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from torquerig.inference import search
from torquerig.inference.addition import Addition
from torquerig.inference.features.line_search import FoundLine
from torquerig.inference.fit import Data
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import Discrepancy
from torquerig.inference.model import Model
from torquerig.inference.places import order

PART = SimpleNamespace(name="hum")
HARMONIC = Addition(mechanism="mains_interference", label="hum at 300 Hz", parts=(PART,))
FUNDAMENTAL = Addition(mechanism="mains_interference", label="hum at 60 Hz", parts=(PART,))
LOAD = SimpleNamespace(name="load.mean")
NO_DATA = Data((), ())


def model(evidence, *additions, load=0.0):
    """Return a model of so much evidence with a number so many standard deviations from its stated value."""
    fit = SimpleNamespace(
        log_evidence=evidence, off=Discrepancy(), unseen=0.0, knobs=(LOAD,), positions=np.array([load])
    )
    return Model(fit, additions, ())


def _finished(fit, _):
    fit.is_finished = True
    return fit


@pytest.fixture
def round_of(monkeypatch):
    """Return a round of the search over models that are fitted already, each with its held-out log-likelihood."""

    def extended(*fits):
        monkeypatch.setattr(search, "moved_lines", lambda *_: [])
        monkeypatch.setattr(search, "proposals", lambda _: [])
        monkeypatch.setattr(search, "_fitted", lambda *_: [made for made, _ in fits])
        for made, unseen in fits:
            made.fit.unseen = unseen
        monkeypatch.setattr(search, "held_out_density", lambda fit, _: fit.unseen)
        monkeypatch.setattr(search, "finished", _finished)
        return search._extended(model(0.0), NO_DATA, NO_DATA)[0]

    return extended


def test_held_out_data_count_as_fitted_ones(round_of):
    # a harmonic that is 0.4 nats ahead in the fitted blocks leaves the fundamental in the others
    best = round_of((model(14.7, HARMONIC), 21.6), (model(14.3, FUNDAMENTAL), 49.0))
    assert best.additions == (FUNDAMENTAL,)
    ((added, other, gap),) = best.alternatives
    assert (added, other) == (FUNDAMENTAL, HARMONIC)
    assert gap == pytest.approx(14.3 + 49.0 - 14.7 - 21.6)


def test_what_fails_on_held_out_data_is_not_taken(round_of):
    best = round_of((model(40.0, HARMONIC), 1.0), (model(14.3, FUNDAMENTAL), 20.0))
    assert best.additions == (FUNDAMENTAL,)


def test_an_effect_without_a_name_wins_by_the_sum_of_its_gains(round_of):
    tone = Addition(kind="tone", label="a tone", parts=(PART,))
    assert round_of((model(0.5, tone), 14.0)).additions == (tone,)
    assert round_of((model(3.9, tone), 0.2)).additions == (tone,)
    for odds, held_out in ((2.0, 1.5), (-0.5, 14.0), (14.0, -0.5)):
        assert round_of((model(odds, tone), held_out)) is None


@pytest.mark.parametrize(("behind", "numbers", "is_named"), [(2.0, 2, True), (4.0, 2, False), (2.0, 4, False)])
def test_a_name_that_does_as_well_with_fewer_numbers_is_preferred(round_of, behind, numbers, is_named):
    knobs = [Knob("x", "amplitudes", 1.0, key=key) for key in range(4)]
    family = Addition(kind="line_family", label="", parts=(PART,), knobs=tuple(knobs))
    blades = Addition(mechanism="blade_pass", label="", parts=(PART,), knobs=tuple(knobs[:numbers]))
    best = round_of((model(40.0, family), 20.0), (model(40.0 - behind, blades), 20.0))
    assert best.additions == ((blades if is_named else family),)
    ((added, other, gap),) = best.alternatives
    assert (added, other, gap) == ((blades, family, 0.0) if is_named else (family, blades, behind))


def test_only_fits_that_may_win_are_finished(round_of):
    best, near, far, worse = (model(gain, HARMONIC) for gain in (30.0, 27.0, 20.0, -4.0))
    round_of((worse, 60.0), (far, 20.0), (near, 20.0), (best, 20.0))
    assert [hasattr(one.fit, "is_finished") for one in (best, near, far, worse)] == [True, True, False, False]


def test_a_sketch_that_gains_too_little_in_all_data_is_not_finished(round_of):
    near, far = model(4.0, HARMONIC), model(4.0, FUNDAMENTAL)  # 11 nats are needed in the sum, and 5 may be missing
    assert round_of((near, 2.5), (far, 1.5)) is None
    assert [hasattr(one.fit, "is_finished") for one in (near, far)] == [True, False]


def test_only_what_may_be_the_best_is_compared_on_held_out_data(round_of, monkeypatch):
    compared = []
    monkeypatch.setattr(search, "_compared", lambda _, one, *args, **options: compared.append(one.additions[-1]) or 0.0)
    round_of((model(30.0, FUNDAMENTAL), 20.0), (model(27.0, HARMONIC), 20.0))
    assert compared == [FUNDAMENTAL]


def test_sketches_of_large_gains_may_be_wrong_by_a_share_of_them(round_of):
    best, near, far = (model(gain, HARMONIC) for gain in (446.0, 430.5, 107.0))
    round_of((best, 323.0), (near, 323.0), (far, 83.0))
    assert [hasattr(one.fit, "is_finished") for one in (best, near, far)] == [True, True, False]


def test_a_fit_is_finished_where_the_best_one_fails_on_held_out_data(round_of):
    failing, other = model(60.0, HARMONIC), model(14.3, FUNDAMENTAL)
    assert round_of((failing, 1.0), (other, 20.0)).additions == (FUNDAMENTAL,)
    assert other.fit.is_finished


class Rig:
    """A rig to which anything can be added."""

    def __add__(self, _):
        return self


@pytest.mark.parametrize(("mechanism", "is_left"), [("", True), ("imbalance", False)])
def test_a_line_of_a_nameless_effect_may_lack_a_second_part(monkeypatch, mechanism, is_left):
    monkeypatch.setattr(search, "sketched", lambda *_, **__: None)
    fit = SimpleNamespace(
        rig=Rig(), nominal=None, knobs=(), positions=np.zeros(0), gains=np.zeros(0), off=None, value=np.zeros(4),
        jacobian=np.zeros((4, 0)),
    )  # fmt: skip
    line = FoundLine(order(3.0), -40.0, 0.0)
    each = Addition(mechanism=mechanism, parts=(PART,), places=(line.place,))
    assert search._together(Model(fit, (), (line,)), NO_DATA, each, ()).lines == ((line,) if is_left else ())


@pytest.mark.parametrize(("before", "after", "unseen"), [(9.0, 0.5, -20.0), (9.0, 3.0, 5.0), (2.5, 0.5, 5.0)])
def test_parts_that_make_a_number_the_stated_one_are_compared_with_that(monkeypatch, before, after, unseen):
    monkeypatch.setattr(search, "refitted", lambda *_, keeps: SimpleNamespace(unseen=-20.0 if not keeps(LOAD) else 0.0))
    monkeypatch.setattr(search, "held_out_density", lambda fit, _: fit.unseen)
    fit, friction = model(0.0, load=before).fit, model(30.0, HARMONIC, load=after)
    assert search._compared(fit, friction, NO_DATA, NO_DATA, 5.0, fits=[friction]) == unseen
