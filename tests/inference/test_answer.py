"""Confidence, errors in N m and held-out data of an answer, against closed forms."""

from __future__ import annotations

from math import exp, log
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from tests.inference.pump_bench import pump_scenario
from torquerig.errors import InputError
from torquerig.inference.addition import Addition
from torquerig.inference.answer import confidence as sure
from torquerig.inference.answer.owned import owned
from torquerig.inference.answer.rms import mean_square
from torquerig.inference.engine import features_of, with_held_out
from torquerig.inference.features.run_features import run_features
from torquerig.inference.held_out import independent
from torquerig.inference.knobs import Knob
from torquerig.inference.likelihood import BAND, Residuals
from torquerig.inference.places import order
from torquerig.inference.prediction.expected_run import ExpectedRun

CHOSEN, SAME = Addition(mechanism="gear_mesh", label="72"), Addition(mechanism="gear_mesh", label="36")
OTHER, NAMELESS = Addition(mechanism="commutation_ripple"), Addition(kind="line_family", parts=(object(),))
NUMBER = Addition(kind="parameter")


def outcome_of(*behind):
    alternatives = tuple((CHOSEN, other, gap) for other, gap in behind)
    return SimpleNamespace(model=SimpleNamespace(additions=(CHOSEN,), alternatives=alternatives, refuted=()))


def test_a_name_far_ahead_of_all_others_is_as_sure_as_the_set_of_hypotheses_is_complete():
    assert sure.confidence(outcome_of(), CHOSEN) == sure.COMPLETE
    assert sure.confidence(outcome_of((NAMELESS, 200.0)), CHOSEN) == pytest.approx(sure.COMPLETE, rel=1e-4)


def test_odds_count_for_less_than_their_nats():
    apart = sure.confidence(outcome_of((OTHER, 4.0 * sure.TEMPER)), CHOSEN)
    assert apart == pytest.approx(sure.COMPLETE / (1 + exp(-4.0)))


def test_the_nearest_of_another_class_lowers_the_confidence():
    outcome = outcome_of((SAME, 1.0), (OTHER, 9.0), (NAMELESS, 5.0))
    assert sure.confidence(outcome, CHOSEN) == pytest.approx(sure.COMPLETE / (1 + exp(-5.0 / sure.TEMPER)))
    assert sure.equivalent_to(outcome, CHOSEN) == []


def test_a_class_has_what_is_near():
    outcome = outcome_of((OTHER, 0.1), (NAMELESS, 3.5))
    assert sure.equivalent_to(outcome, CHOSEN) == ["commutation_ripple"]
    assert sure.confidence(outcome, CHOSEN) == pytest.approx(sure.COMPLETE / (1 + exp(-3.5 / sure.TEMPER)))


@pytest.mark.parametrize(("gap", "listed"), [(0.0, ["line_family"]), (2.9, ["line_family"]), (3.1, [])])
def test_a_name_is_reported_with_the_nameless_line_that_ties_with_it(gap, listed):
    outcome = outcome_of((NAMELESS, gap), (OTHER, 30.0))
    assert sure.equivalent_to(outcome, CHOSEN) == listed
    assert [each is CHOSEN for each in sure.named(outcome)] == [True]
    outside = 30.0 if listed else gap
    assert sure.confidence(outcome, CHOSEN) == pytest.approx(sure.COMPLETE / (1 + exp(-outside / sure.TEMPER)))


@pytest.mark.parametrize(("stated", "is_named"), [(0.59, False), (0.61, True)])
def test_below_six_tenths_nothing_is_named(stated, is_named):
    outcome = outcome_of((NUMBER, -sure.TEMPER * log(sure.COMPLETE / stated - 1)))
    assert sure.confidence(outcome, CHOSEN) == pytest.approx(stated)
    assert [each is CHOSEN for each in sure.named(outcome)] == ([True] if is_named else [])
    assert [each is CHOSEN for each in sure.nameless(outcome)] == ([] if is_named else [True])


def test_a_missing_line_is_an_error_of_its_rms():
    seen = run_features(drawn_run(1, speed=steady(1000), orders={7.0: 0.5}, level=2.0), [order(7.0)])
    count, bands = len(seen.segments), seen.bands.middle.size
    white = np.full((count, bands), 2 * 0.1**2 / 2000.0)
    nothing = np.zeros((count, 1))
    levels = np.zeros(seen.level.size)
    model = ExpectedRun(
        line_power=nothing, line_slope=nothing, line_range=nothing, density=white, load_share=white,
        level=levels + 2.0, level_covariance=np.diag(levels), slow_load=np.diag(levels), level_rate=levels,
        level_range=levels, near_lines=nothing, near_bands=np.zeros(white.shape),
        line_beat=nothing,
    )  # fmt: skip
    found = np.sqrt(mean_square(seen, model))
    # the line has 0.354 N m rms; spectra of some bins scatter by a tenth of the noise of 0.1 N m
    assert found == pytest.approx(0.5 / np.sqrt(2), rel=0.02)


def test_an_open_gain_leaves_independent_residuals():
    rng = np.random.default_rng(2)
    slope = rng.uniform(0.5, 2.0, (40, 1))
    squares, sums = [], []
    for _ in range(2000):
        value = rng.standard_normal(40) + slope[:, 0] * rng.standard_normal()
        rows = np.arange(40)
        made, logdet = independent(Residuals(value, np.ones(40), np.full(40, BAND, np.int8), rows, rows), slope)
        squares.append(np.mean(made.value**2))
        sums.append(slope[:, 0] @ made.value)
    assert np.mean(squares) == pytest.approx(1.0, abs=0.02)
    assert np.var(sums) == pytest.approx(float(slope[:, 0] @ slope[:, 0]), rel=0.15)
    assert logdet == pytest.approx(np.log1p(float(slope[:, 0] @ slope[:, 0])))


RUNS = [drawn_run(seed, speed=steady(rpm), name=name) for seed, rpm, name in ((1, 900, "a"), (2, 1400, "b"))]


def test_a_run_that_is_held_out_is_in_no_fit():
    runs = with_held_out(RUNS, ["b"])
    assert [seen.run.name for seen in features_of(runs, []).seen] == ["a"]
    held = features_of(runs, [], held_out=True)
    assert [seen.run.name for seen in held.seen] == ["b"]
    assert sum(len(segment.blocks) for segment in held.seen[0].segments) == len(runs[1].blocks)


@pytest.mark.parametrize(("names", "text"), [(["c"], "no recording has this name"), (["a", "b"], "at least one")])
def test_names_that_cannot_be_held_out_are_refused(names, text):
    with pytest.raises(InputError, match=text):
        with_held_out(RUNS, names)


MORE = """\
  drag: {kind: quadratic_drag, at: pump, coefficient: 3e-5 N*m*s^2/rad^2}
  windings: {kind: torque_ripple, at: motor, group: electrical, amplitudes: {24: 0.05 N*m}}
"""


def fitted_number(folder, part, field, factor, *, key=None):
    rig = pump_scenario(folder, MORE).rig
    knob = Knob(part, field, 1.0, key=key)
    fit = SimpleNamespace(
        knobs=(knob,), positions=np.array([log(factor)]), rig=rig, nominal=rig, covariance=lambda: np.array([[1e-4]])
    )
    return SimpleNamespace(model=SimpleNamespace(fit=fit)), Addition(kind="parameter", knobs=(knob,))


@pytest.mark.parametrize(
    ("number", "factor", "key", "mechanism", "parameter", "value"),
    [
        (("drag", "coefficient"), 3.0, None, "quadratic_drag", "coefficient_Nms2", 9e-5),
        (("windings", "amplitudes"), 2.0, 24.0, "commutation_ripple", "amplitude_Nm", 0.1),
        (("sensor", "bandwidth"), 0.4, None, "sensor_bandwidth", "cutoff_Hz", 200.0),
    ],
)
def test_a_number_that_a_mechanism_owns_is_a_finding(tmp_path, number, factor, key, mechanism, parameter, value):
    found = owned(*fitted_number(tmp_path, *number, factor, key=key))
    assert found.mechanism == mechanism
    assert found.parameters[parameter]["value"] == pytest.approx(value, rel=1e-5)
    low, high = found.parameters[parameter]["ci95"]
    assert (low, high) == pytest.approx((value * exp(-0.0196), value * exp(0.0196)), rel=1e-4)


@pytest.mark.parametrize(("number", "factor"), [(("pump", "viscous"), 3.0), (("sensor", "bandwidth"), 2.0)])
def test_other_numbers_are_facts_of_the_set_up(tmp_path, number, factor):
    assert owned(*fitted_number(tmp_path, *number, factor)) is None
