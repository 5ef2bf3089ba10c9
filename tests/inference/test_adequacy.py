"""The test of adequacy: p-values of a true model, and what is found."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.adequacy import JudgedRun, excesses, judged_run
from torquerig.inference.features.run_features import run_features
from torquerig.inference.likelihood import BAND, DEGREES_OF_FREEDOM, LEVEL, LINE, Residuals
from torquerig.inference.places import Place


def drawn(rng, *, odd: float = 0.0, wide: float = 1.0, size: float = 1.0) -> JudgedRun:
    """Return residuals of 300 features; ``wide`` multiplies all, ``odd`` is added to the first line."""
    value = wide * rng.standard_t(DEGREES_OF_FREEDOM, 300)
    value[0] += odd
    kind = np.repeat([LINE, BAND, LEVEL], 100).astype(np.int8)
    each = Residuals(value, np.ones(300), kind, np.arange(300), np.zeros(300, dtype=np.intp))
    beyond = 0.01 * size**2 * (value**2 - DEGREES_OF_FREEDOM / (DEGREES_OF_FREEDOM - 2))
    excess = {one: float(beyond[kind == one].sum()) for one in (LINE, BAND, LEVEL)}
    return JudgedRun(None, each, np.full(300, size), excess)


def least_likely(runs, *, relevance=0.0):
    return excesses(runs, relevance)[0]


def test_p_values_of_a_true_model_are_conservative():
    rng = np.random.default_rng(3)
    least = np.array([least_likely([drawn(rng)]).p_value for _ in range(400)])
    for level in (0.01, 0.05, 0.2):
        assert np.mean(least < level) < level + 4 * np.sqrt(level / 400)
    assert 0.1 < np.median(least) < 0.9  # neither blind nor alarmed


def test_one_odd_line_is_located():
    found = least_likely([drawn(np.random.default_rng(4)), drawn(np.random.default_rng(5), odd=40.0)])
    assert (found.statistic, found.run, found.row) == ("largest of lines", 1, 0)
    assert found.p_value < 1e-6


def test_what_is_smaller_than_the_relevance_does_not_count():
    runs = [drawn(np.random.default_rng(5), odd=40.0, size=0.02)]
    assert least_likely(runs, relevance=0.01).p_value < 1e-6
    assert least_likely(runs, relevance=0.2).p_value == 1.0


@pytest.mark.parametrize("wide", [1.5, 2.0])
def test_a_misfit_that_is_spread_over_many_small_features_is_found(wide):
    runs = [drawn(np.random.default_rng(seed), wide=wide) for seed in (7, 8)]
    assert least_likely(runs, relevance=0.1).p_value < 1e-6
    # of no single residual is the size known to matter, of all together it is
    assert least_likely(runs, relevance=1.5).statistic.startswith("sum")
    assert least_likely(runs, relevance=100.0).p_value == 1.0


def test_runs_without_lines_are_judged_by_the_other_features():
    whole = drawn(np.random.default_rng(6))
    kept = whole.residuals.kind != LINE
    rest = Residuals(*(getattr(whole.residuals, name)[kept] for name in ("value", "sd", "kind", "at", "segment")))
    found = excesses([JudgedRun(None, rest, np.ones(kept.sum()), {LINE: 0.0, BAND: 0.0, LEVEL: 0.0})], 0.0)
    assert {each.kind for each in found} == {BAND, LEVEL}


def test_the_error_that_is_to_be_expected_of_a_true_model_is_no_excess():
    seen = run_features(drawn_run(1, speed=steady(1000)), [])
    rng, totals = np.random.default_rng(9), []
    for _ in range(200):
        shown = np.flatnonzero(np.isfinite(seen.band_power[0]))
        sd = np.full(shown.size, 0.1)
        each = Residuals(0.1 * rng.standard_normal(shown.size), sd, np.full(shown.size, BAND, dtype=np.int8), shown,
                         np.zeros(shown.size, dtype=np.intp))  # fmt: skip
        totals.append(judged_run(seen, each).excess[BAND])
    assert abs(np.mean(totals)) < 4 * np.std(totals) / np.sqrt(len(totals))


@pytest.mark.parametrize("common", [0.5, 0.8])
def test_errors_that_neighbours_have_in_common_are_no_misfit(common):
    rng, found = np.random.default_rng(11), []
    segment = np.repeat(np.arange(20), 30)
    for _ in range(300):
        shared = np.repeat(rng.standard_normal(20), 30)
        value = np.sqrt(common) * shared + np.sqrt(1 - common) * rng.standard_normal(600)
        value *= np.sqrt(DEGREES_OF_FREEDOM / (DEGREES_OF_FREEDOM - 2))  # the variance of Student's distribution
        each = Residuals(value, np.ones(600), np.full(600, BAND, dtype=np.int8), np.arange(600), segment)
        run = JudgedRun(None, each, np.ones(600), {LINE: 0.0, BAND: 1.0, LEVEL: 0.0})
        found.append(min(one.p_value for one in excesses([run], 0.5) if one.statistic.startswith("sum")))
    assert np.mean(np.array(found) < 0.01) < 0.04


def at_places(*, shift=0.0, common=0.0):
    """Return residuals of ten places in each of 16 segments, of which one is ``shift`` too high in all."""
    rng = np.random.default_rng(11)
    value = rng.standard_t(DEGREES_OF_FREEDOM, (16, 10)) + shift * (np.arange(10) == 3)
    each = Residuals(value.ravel(), np.ones(160), np.full(160, LINE, dtype=np.int8), np.tile(np.arange(10), 16),
                     np.repeat(np.arange(16), 10))  # fmt: skip
    seen = SimpleNamespace(places=[Place("order", 1.0 + at) for at in range(10)])
    excess = dict.fromkeys((LINE, BAND, LEVEL), 0.0)
    return JudgedRun(seen, each, np.ones(160), excess, common=np.full(160, common))


def test_a_line_that_is_too_high_in_many_segments_is_found():
    found = least_likely([at_places(shift=2.0)])
    assert (found.statistic, found.row % 10) == ("mean of lines", 3)
    assert found.p_value < 1e-3
    assert least_likely([at_places()]).p_value > 0.05
    # what a right model may be wrong by is the same in all segments
    assert least_likely([at_places(shift=2.0, common=0.9)]).p_value > 0.05
