"""Lines and bands that change within a run at one speed."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.adequacy import excesses, judged_run
from torquerig.inference.features.run_features import run_features
from torquerig.inference.likelihood import BAND, LINE, Discrepancy, residuals
from torquerig.inference.places import frequency, order
from torquerig.inference.unsteady import changes

NOISE, RATE = 0.1, 2000.0
DENSITY = 2 * NOISE**2 / RATE  # one-sided density of white noise
PLACES = [order(7.0), frequency(90.0)]


def seen_of(seed, *, moved=lambda share: 0.0 * share, speed=None, orders=None):
    """Return the features of a run with a line of order 7 to whose torque something is added, and a model of it."""
    run = drawn_run(seed, speed=steady(1000) if speed is None else speed, orders=orders or {7.0: 0.5}, noise=NOISE)
    run = replace(run, torque=run.torque + moved(np.arange(run.torque.size) / run.torque.size))
    seen = run_features(run, PLACES)
    lines = (len(seen.segments), len(PLACES))
    bands = (len(seen.segments), seen.bands.low.size)
    power = np.where(np.arange(2) == 0, 0.25, 0.0) * np.ones(lines)
    levels = seen.level.size
    model = SimpleNamespace(
        line_power=power, density=np.full(bands, DENSITY), load_share=np.zeros(bands), line_range=np.zeros(lines),
        line_beat=np.zeros(lines), near_lines=np.zeros(lines), near_bands=np.zeros(bands), line_slope=np.zeros(lines),
        level=np.ones(levels), level_covariance=1e-4 * np.eye(levels), level_rate=np.zeros(levels),
        level_range=np.zeros(levels), line_error=0.0, density_error=0.0, level_error=0.0, load_clumping=0.0,
    )  # fmt: skip
    return seen, model


def tone(at, amplitude):
    return lambda share: amplitude * np.cos(2 * np.pi * at * 12.0 * share)


def test_what_is_steady_is_steady():
    least = [changes([seen_of(seed), seen_of(seed + 100)]) for seed in range(12)]
    p_values = np.array([len(each) * each[0].p_value for each in least])  # Bonferroni
    assert np.mean(p_values < 0.1) < 0.1 + 3 * np.sqrt(0.09 / 12)
    assert min(p_values) > 1e-4


@pytest.mark.parametrize(
    "course", [lambda x: x > 0.5, lambda x: np.sin(20 * x) > 0, lambda x: x], ids=["half", "on and off", "growing"]
)
def test_a_tone_that_comes_and_goes_changes(course):
    first = changes([seen_of(3, moved=lambda x: course(x) * tone(90.0, 0.5)(x))])[0]
    assert (first.kind, first.row) == (LINE, 1)
    assert first.p_value < 1e-8
    assert 0.05 < first.size < 0.5  # of its rms of 0.35 N m


def test_a_band_whose_noise_moves_changes():
    rng = np.random.default_rng(5)
    slow = np.repeat(rng.standard_normal((2, 240)), 100, axis=1)

    def moving(share):
        turned = 2 * np.pi * 12.0 * (300.0 * share + 15.0 * np.sin(2 * np.pi * share))
        return 0.3 * (slow[0] * np.cos(turned) + slow[1] * np.sin(turned))

    first = changes([seen_of(3, moved=moving)])[0]
    assert first.kind == BAND
    assert first.p_value < 1e-8


def test_a_run_that_changes_its_speed_is_not_tested():
    assert changes([seen_of(3, moved=tone(90.0, 0.5), speed=ramp(3000))]) == ()


def test_a_change_is_a_statistic_of_adequacy():
    seen, model = seen_of(3, moved=lambda x: (x > 0.5) * tone(90.0, 0.5)(x))
    model.line_power[:, 1] = 0.125  # the mean: as a model with a steady tone has it
    run = judged_run(seen, residuals(seen, model, Discrepancy()))
    with_it, without = (excesses([run], 0.1, changed=changed) for changed in (changes([(seen, model)]), ()))
    assert with_it[0].changes
    assert with_it[0].p_value < 1e-6 < without[0].p_value
    assert seen.places[int(run.residuals.at[with_it[0].row])] == PLACES[1]
    assert not any(each.changes and each.p_value < 1 for each in excesses([run], 1.0, changed=changes([(seen, model)])))
