"""How far a model is off: too large a line is as wrong as too small a one, and the larger the worse."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.choosing.explained import explained_share, left_at_its_places
from torquerig.diagnosis.expecting.expectation import Expectation, expected
from torquerig.diagnosis.fitting.misfit import LINE_TOLERANCE, Misfit, misfit
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import frequency, order
from torquerig.scenario.model import Scenario

RATE = 5000.0


@pytest.fixture(scope="module")
def seen(by_hand: Callable[..., Observed]) -> Features:
    """A line of 0.3 N m at order 5.3, in noise of 1 mN m, at 1000 rpm for 12 s."""
    angle = 1000 * pi / 30 * np.arange(int(12 * RATE)) / RATE
    noise = 1e-3 * np.random.default_rng(2).standard_normal(angle.size)
    return features(by_hand(1.0 + 0.3 * np.cos(5.3 * angle) + noise, angle, rate=RATE), [order(5.3)])


def with_line(seen: Features, wear_rig: Scenario, size: float) -> Expectation:
    model = expected(wear_rig.rig.at(seen.observed.run), seen)
    return replace(model, amplitude=np.full(model.amplitude.shape, size), variance=np.full(model.variance.shape, 1e-8))


def test_half_and_twice_the_size_are_equally_wrong(seen: Features, wear_rig: Scenario) -> None:
    low, high = (float(misfit(seen, with_line(seen, wear_rig, 0.3 * by)).lines[0]) for by in (0.5, 2.0))
    assert low == pytest.approx(-high, rel=0.01)
    assert low == pytest.approx(2**-0.5 / LINE_TOLERANCE, rel=0.02), "the tolerance is of the geometric mean"


def test_no_model_is_so_large_that_a_larger_one_is_no_worse(seen: Features, wear_rig: Scenario) -> None:
    off = [abs(float(misfit(seen, with_line(seen, wear_rig, size)).lines[0])) for size in (0.3, 3.0, 30.0, 300.0)]
    assert off[0] < 1.0
    assert np.all(np.diff(np.log(off[1:])) > 1.0)


def test_a_large_line_of_the_model_alone_forgives_no_other_line(
    by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    angle = 1000 * pi / 30 * np.arange(int(12 * RATE)) / RATE
    torque = 1.0 + 0.05 * np.cos(5.3 * angle) + 1e-4 * np.random.default_rng(2).standard_normal(angle.size)
    both = features(by_hand(torque, angle, rate=RATE), [order(5.3), order(9.7)])
    model = with_line(both, wear_rig, 0.0)
    alone, beside = model.amplitude.copy(), model.amplitude.copy()
    beside[:, 1] = 100.0
    far = [float(misfit(both, replace(model, amplitude=each)).lines[0]) for each in (alone, beside)]
    assert far[1] > 0.7 * far[0] > 50


def test_a_smeared_line_of_the_model_alone_forgives_no_other_line(
    by_hand: Callable[..., Observed], wear_rig: Scenario
) -> None:
    """Where nobody measured the angle of a ramp a line strays to its neighbours, but no more than is seen of it."""
    time = np.arange(int(12 * RATE)) / RATE
    angle = 2 * pi * np.cumsum(4.0 + 14.0 * time / 12) / RATE
    torque = 1.0 + 0.05 * np.cos(28.8 * angle) + 0.05 * np.cos(31.0 * angle)
    torque = torque + 1e-4 * np.random.default_rng(2).standard_normal(time.size)
    run = by_hand(torque, angle, rate=RATE, profile="ramp", measured=False)
    both = features(run, [order(28.8), order(31.0)])
    model = with_line(both, wear_rig, 0.0)
    sums = []
    for size in (0.05, 1.0):
        amplitude = model.amplitude.copy()
        amplitude[:, 0] = size
        sums.append(float(np.abs(misfit(both, replace(model, amplitude=amplitude)).lines[:, 1]).sum()))
    assert sums[1] > 0.8 * sums[0] > 10


def row(*values: float) -> tuple[Misfit, ...]:
    return (Misfit(np.zeros(0), np.zeros(0), np.array(values)),)


def test_the_share_counts_what_changes_and_what_no_feature_holds() -> None:
    before, after = row(10.0, 0.5, 0.5), row(1.0, 0.5, 0.5)
    assert explained_share(before, after) == pytest.approx(1.0)
    assert explained_share(before, before) == 0.0
    assert explained_share(before, before, beside=(100.0, 10.0)) == pytest.approx(0.9)


def test_what_the_final_model_leaves_is_looked_at_where_the_effect_acted() -> None:
    before, with_it = row(*[10.0] * 6, 0.0), row(*[3.0] * 6, 0.0)
    assert left_at_its_places(before, with_it, row(*[0.5] * 6, 30.0)) < 1.0
    assert left_at_its_places(before, with_it, row(*[5.0] * 6, 0.0)) > 6.0
    assert left_at_its_places(before, before, row(*[5.0] * 6, 0.0)) == 0.0


def test_a_single_feature_that_stays_wrong_is_no_place() -> None:
    """An effect of lines changes one or two of the slow torque: that these miss says little of the lines."""
    before, with_it = row(10.0, 0.0), row(3.0, 0.0)
    assert left_at_its_places(before, with_it, row(3.0, 0.0)) < 2.0


def test_an_effect_of_lines_does_not_answer_for_the_slow_torque() -> None:
    """A mesh that takes a strong line away moves the level a little with it, which was wrong and stays so."""

    def case(line: float, level: float) -> list[Misfit]:
        return [Misfit(np.zeros(0), np.array([line]), np.full(6, level))]

    before, with_it = case(1000.0, 5.0), case(0.0, 4.5)
    assert left_at_its_places(before, with_it, with_it) == 0.0
    small = case(10.0, 5.0)
    assert left_at_its_places(small, with_it, with_it) > 6.0


def test_a_zero_that_settles_within_a_second_is_seen_in_the_first_parts(by_hand: Callable[..., Observed]) -> None:
    time = np.arange(int(12 * RATE)) / RATE
    tau = 0.6
    seen = features(by_hand(1.0 + 0.4 * (1 - np.exp(-time / tau)), 100 * time, rate=RATE), [])
    ends = [(part.start / RATE, part.stop / RATE) for part in seen.parts]
    told = [1.4 - 0.4 * tau * (np.exp(-low / tau) - np.exp(-high / tau)) / (high - low) for low, high in ends]
    assert len(seen.parts) == 4 * len(seen.stretches)
    assert seen.level == pytest.approx(told, abs=1e-3)


def test_an_order_that_sweeps_across_a_fixed_line_is_told_from_it(by_hand: Callable[..., Observed]) -> None:
    """In a ramp, not at one speed: both stand in one stretch, and each has its own size."""
    time = np.arange(int(12 * RATE)) / RATE
    angle = 2 * pi * np.cumsum(2.0 + 18.0 * time / 12) / RATE
    torque = 0.2 * np.cos(3.0 * angle) + 0.1 * np.cos(2 * pi * 30.0 * time)
    ramp = features(by_hand(torque, angle, rate=RATE, profile="ramp"), [order(3.0), frequency(30.0)], held=None)
    at = int(np.argmin(np.abs(ramp.line_frequency[:, 0].mean(axis=1) - 30.0)))
    assert np.abs(ramp.amplitude[at]) == pytest.approx([0.2, 0.1], rel=0.05)
    steady = 2 * pi * 10.0 * time
    torque = 0.2 * np.cos(3.0 * steady) + 0.1 * np.cos(2 * pi * 30.0 * time + 1.0)
    one = features(by_hand(torque, steady, rate=RATE), [order(3.0), frequency(30.0)])
    assert np.isnan(one.amplitude[:, 1]).all()


def test_a_line_counts_where_a_stretch_shows_it(seen: Features, wear_rig: Scenario) -> None:
    """Where another stands beside it, its place is shown in some stretches, and the model has it there alone too."""
    half, model = seen.amplitude.copy(), with_line(seen, wear_rig, 0.3)
    half[::2] = np.nan
    there = np.where(np.isfinite(half), model.amplitude, 0.0)
    for given in (model, replace(model, amplitude=there)):
        assert abs(float(misfit(replace(seen, amplitude=half), given).lines[0])) < 1.0
    nowhere = replace(seen, amplitude=np.full(seen.amplitude.shape, np.nan + 0j))
    assert misfit(nowhere, model).lines.tolist() == [0.0]


def test_of_a_run_with_rebuilt_moments_only_what_a_model_has_too_much_counts(
    seen: Features, wear_rig: Scenario
) -> None:
    model = expected(wear_rig.rig.at(seen.observed.run), seen)
    model = replace(model, power=seen.power.copy(), load_share=np.ones(seen.power.size), load_doubt=0.0)
    flat = replace(seen, observed=replace(seen.observed, rebuilt=True), power=np.full(seen.power.shape, np.nan))

    def bands(by: float) -> np.ndarray:
        return misfit(flat, replace(model, power=by * model.power)).bands

    assert not bands(1.0).any()
    assert not bands(0.1).any(), "the ends of the moments ring through the spectrum"
    assert not bands(1.5).any(), "what is rebuilt is lower than what was cut off"
    assert np.median(bands(60.0)[seen.band > 50]) < -2.0


@pytest.mark.parametrize(("doubt", "left", "paid"), [(0.0, 0.5, 0.0), (0.4, 0.0, 1.25)], ids=["loaded", "idle"])
def test_the_power_of_an_idle_load_may_be_off_as_a_whole_at_a_price(
    doubt: float, left: float, paid: float, seen: Features, wear_rig: Scenario
) -> None:
    """By half in its logarithm: known to a tenth it stays wrong in each band, to 0.4 it costs 1.25 spreads once."""
    model = with_line(seen, wear_rig, 0.3)
    load = np.ones(seen.power.size)
    off = replace(model, power=seen.power * np.exp(-0.5), load_share=load, load_doubt=doubt)
    shown = misfit(seen, off)
    spread = np.sqrt(1 / seen.count + 0.05**2)
    np.testing.assert_allclose(shown.bands * spread, left, atol=0.02)
    assert float(shown.price[-1]) == pytest.approx(paid, abs=0.02)


def test_what_no_load_makes_is_not_excused_by_it(seen: Features, wear_rig: Scenario) -> None:
    model = with_line(seen, wear_rig, 0.3)
    share = np.where(seen.band < 200, 1.0, 0.0)
    off = replace(
        model, power=seen.power * np.exp(np.where(seen.band < 200, 0.0, -0.5)), load_share=share, load_doubt=0.4
    )
    shown = misfit(seen, off)
    assert float(np.abs(shown.bands[seen.band < 200]).max()) < 0.01
    assert float(shown.bands[seen.band > 200].min()) > 2


@pytest.mark.parametrize(("percent", "doubt"), [(0.0, 0.4), (5.0, 0.0)])
def test_the_load_of_an_idle_rig_is_in_doubt_and_no_other(
    percent: float, doubt: float, seen: Features, wear_rig: Scenario
) -> None:
    """A hundredth of a newton metre of a mean of 0.05, twice as much of its power; of 1 N m it is nothing."""
    recording = seen.observed.recording
    idle = replace(recording, run=replace(recording.run, occupancy_percent=percent))
    shown = replace(seen, observed=replace(seen.observed, recording=idle))
    assert expected(wear_rig.rig, shown).load_doubt == pytest.approx(doubt, rel=1e-6)


def test_what_was_called_chance_counts_in_the_spreads_of_a_surer_model() -> None:
    """Levels off by 1 N m count 1 in spreads of 1 N m, 4 in those of a model with a quarter of them; never less."""
    none, off = np.zeros(0), np.ones(4)
    unsure, sure = (Misfit(none, none, off / by, level_spread=np.full(4, by)) for by in (1.0, 0.25))
    assert unsure.as_sure_as(sure).level == pytest.approx(sure.level)
    assert sure.as_sure_as(unsure).level == pytest.approx(sure.level)
    turning_back = Misfit(none, none, none, turning=off)
    assert turning_back.as_sure_as(sure) is turning_back
