"""Beats of an envelope: found at the order of impacts, not where noise or a slower rhythm is."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.signal import lfilter

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference.additions import bearing_defect
from torquerig.inference.features.impacts import Impact, search_impacts
from torquerig.inference.features.run_features import run_features
from torquerig.inference.prediction.measuring_chain import crosstalk_lines
from torquerig.inference.prediction.ringing import ringing_density, ringing_lines, share_in_line
from torquerig.sensor_stages.crosstalk import Crosstalk
from torquerig.sensor_stages.ringing import Ringing

RATE = 2000.0


def struck(order, *, seed, size=0.5, frequency=420.0, damping=0.03):
    """Return a run with rings of a mode, ``order`` times a turn."""
    run = drawn_run(seed, speed=steady(1200, rate=RATE), rate=RATE, noise=0.05)
    passed = np.floor(run.angle * order / (2 * np.pi))
    kicks = np.concatenate([[0.0], np.diff(passed)])
    pole = np.exp(2 * np.pi * frequency * (1j - damping) / RATE)
    return replace(run, torque=run.torque + size * lfilter([1.0], [1.0, -pole], kicks.astype(complex)).imag)


def found(*runs):
    return search_impacts(tuple(run_features(run, []) for run in runs), 1.0)


def test_impacts_are_found_at_their_order_and_not_at_a_multiple():
    impact = found(struck(3.57, seed=1), struck(3.57, seed=2))
    assert impact.order == pytest.approx(3.57, rel=0.005)
    assert 250 < impact.frequency < 650  # half-octave bands next to 420 Hz


def test_noise_has_no_impacts():
    # p-value 1e-4 a search
    assert [found(drawn_run(seed, speed=steady(1200))) for seed in range(20, 30)] == [None] * 10


def test_what_passes_once_in_three_turns_is_no_bearing():
    assert found(struck(1 / 3, seed=3, size=2.0), struck(1 / 3, seed=4, size=2.0)) is None


@pytest.mark.parametrize("multiple", [1, 4, 12])
@pytest.mark.parametrize("slip", [0.002, 0.012])
def test_impacts_that_slip_leave_in_a_line_what_a_random_walk_leaves(multiple, slip):
    rng, impacts, power = np.random.default_rng(1), 300, []
    for _ in range(200):
        turned = np.cumsum(1 + slip * rng.standard_normal(impacts)) - rng.uniform()
        window = 0.5 * (1 - np.cos(2 * np.pi * np.clip(turned / impacts, 0, 1)))
        power.append(abs((window * np.exp(2j * np.pi * multiple * turned)).sum() / window.sum()) ** 2)
    share = share_in_line(np.array(multiple), slip, impacts)
    assert np.mean(power) == pytest.approx(share, rel=0.25)  # 200 exponential variates: 3 sd are 0.21
    assert np.log(power).var() == pytest.approx(np.pi**2 / 6 * (1 - share) ** 2, rel=0.5, abs=0.1)


def test_impacts_of_a_slow_shaft_are_found_over_the_whole_run():
    # a block has 2 turns of the shaft
    runs = [struck(3.57 / 20, seed=seed) for seed in (5, 6)]
    impact = search_impacts(tuple(run_features(run, []) for run in runs), 1 / 20)
    assert impact.order == pytest.approx(3.57, abs=0.05)


def test_a_band_without_a_ring_does_not_beat():
    impact = found(struck(3.57, seed=1, size=0.1), struck(3.57, seed=2, size=0.1))
    assert impact.log_p_near(420.0) < np.log(1e-6)
    assert impact.log_p_near(30.0) > np.log(1e-2)


def test_a_beat_says_nothing_of_frequencies_without_a_searched_band():
    impact = Impact(2.77, 78.0, {78.0: -14.7, 110.4: 0.0}, 0.01)
    assert impact.log_p_near(80.0) == -14.7
    assert impact.log_p_near(1.16) == 0.0


def proposed(monkeypatch, impact):
    shaft = SimpleNamespace(part="drum", turns=0.034)
    context = SimpleNamespace(shafts=[shaft], data=SimpleNamespace(seen=()), rig=SimpleNamespace(of_kind=lambda _: ()),
                              bands_above=list)  # fmt: skip
    monkeypatch.setattr(bearing_defect, "search_impacts", lambda *_: impact)
    monkeypatch.setattr(bearing_defect, "_impacts", lambda *_: "impacts")
    return len([*bearing_defect.propose(context)])


@pytest.mark.parametrize(("order", "step", "count"), [(2.055, 0.085, 0), (2.055, 0.01, 1), (2.77, 0.085, 1)])
def test_impacts_are_at_an_order_that_the_search_separates_from_whole_ones(monkeypatch, order, step, count):
    assert proposed(monkeypatch, Impact(order, 78.0, {78.0: -14.7}, step)) == count


@pytest.mark.parametrize(("frequency", "count"), [(78.0, 1), (10.5, 0)])
def test_no_bearing_rings_at_some_hertz(monkeypatch, frequency, count):
    assert proposed(monkeypatch, Impact(2.77, frequency, {frequency: -14.7}, 0.01)) == count


def test_impacts_that_the_load_makes_stronger_once_a_turn_keep_their_order():
    def modulated(run):
        return replace(run, torque=run.torque * (1 + 0.8 * np.cos(run.angle / 20)))

    runs = [modulated(struck(3.31 / 20, seed=seed)) for seed in (7, 8)]
    impact = search_impacts(tuple(run_features(run, []) for run in runs), 1 / 20)
    assert impact.order == pytest.approx(3.31, abs=0.05)


def behind(turns):
    """Return what is expected of impacts and of bending at a shaft of so many turns per turn of the motor."""
    stages = [
        Ringing(order=6.3, frequency=340.0, damping=0.03, amplitude=0.1, slip=0.01, turns=turns, source="bearing"),
        Crosstalk(once=0.1, turns=turns, source="bending"),
    ]
    ones = np.ones_like
    twin = SimpleNamespace(rig=SimpleNamespace(stages=lambda: stages), amplifier_power=ones, amplifier=ones)
    seen = run_features(drawn_run(1, speed=steady(1200)), [])
    return ringing_density(twin, seen), ringing_lines(twin, seen).frequency, crosstalk_lines(twin, seen)[0]


def test_a_gear_that_reverses_changes_neither_impacts_nor_bending():
    forward, backward = behind(0.25), behind(-0.25)
    assert forward[0].max() > 0
    assert all(np.array_equal(*each) for each in zip(forward, backward, strict=True))
