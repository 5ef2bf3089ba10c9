"""Lines of a run whose angle was not measured: what the angle does not follow makes them wider than a bin."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, steady
from torquerig.inference import context
from torquerig.inference.additions import cogging
from torquerig.inference.features.line_powers import line_powers
from torquerig.inference.features.run_features import run_features
from torquerig.inference.places import order
from torquerig.inference.prediction.skirts import Skirts, smears
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Motor

RATE = 5000.0  # [Hz]
AMPLITUDE = 0.05  # [N m]


@pytest.mark.parametrize(("first", "last"), [(62.0, 62.0), (60.7, 62.8), (50.0, 70.0), (-62.8, -60.7)])
def test_a_line_that_sweeps_keeps_its_power(first, last):
    speed = np.linspace(first, last, int(0.75 * RATE))
    run = drawn_run(1, speed=speed, rate=RATE, orders={24.0: AMPLITUDE, 6.0: 0.1}, noise=1e-4)
    turned = replace(run, has_encoder=False, angle=1.004 * run.angle)
    lines = line_powers(turned, slice(0, speed.size), [order(6.0), order(24.0)])
    assert lines.half_width[1] * 0.75 > 2.0  # [bins]: wider than what a regression fits
    assert lines.power[1] == pytest.approx(AMPLITUDE**2, rel=0.1)


def test_noise_adds_what_is_said():
    speed = np.linspace(58.0, 66.0, int(0.75 * RATE))
    drawn = [drawn_run(seed, speed=speed, rate=RATE, noise=0.1) for seed in range(60)]
    lines = [line_powers(replace(run, has_encoder=False), slice(0, speed.size), [order(24.0)]) for run in drawn]
    density = 0.1**2 / (0.5 * RATE)
    expected = lines[0].noise_bandwidth[0] * density
    assert float(np.mean([each.power[0] for each in lines])) == pytest.approx(expected, rel=0.15)


def test_no_search_finds_a_line_whose_phase_sways_by_radians():
    frequency = np.geomspace(0.1, 100.0, 200)
    skirts = Skirts(frequency, np.zeros(200), np.where(frequency < 10.0, 0.02, 0.0))  # an rms of 0.14 rad
    seen = run_features(drawn_run(1, speed=steady(1200)), [])
    assert [smears(skirts, seen, order) for order in (2.0, 24.0)] == [False, True]
    assert not smears(None, seen, 24.0)


def test_cogging_that_no_search_finds_is_proposed_with_the_power_that_bands_lack(monkeypatch):
    motor = Motor(name="motor", inertia=1e-5, slots=6, pole_pairs=4, torque_limit=1.0)
    bands = SimpleNamespace(low=np.array([100.0, 200.0]), high=np.array([200.0, 300.0]))
    seen = SimpleNamespace(bands=bands, band_power=np.array([[5e-6, np.nan]]), segments=("one",))
    expected = SimpleNamespace(density=np.array([[1e-6, 1e-6]]))
    fit = SimpleNamespace(fitted_rig=Rig((motor,)), expected=(expected,))
    own = context.Context(fit, SimpleNamespace(seen=(seen,)), ())
    monkeypatch.setattr(context.Context, "smeared", lambda _, orders: [order for order in orders if order != 6])
    monkeypatch.setattr(context.Context, "signal", 0.1)
    louder = SimpleNamespace(density=np.array([[1e-6 + 1e-2, 1e-6 + 1e-2]]))  # per square of an amplitude of 1 N m
    monkeypatch.setattr(context, "expected_run", lambda *_: louder)
    both, _ = cogging.propose(own)
    (start,) = both.starts
    at = [knob.turned(knob.value(Rig((motor, *both.parts))), one) for knob, one in zip(both.knobs, start, strict=True)]
    assert [knob.field for knob in both.knobs] == ["native", "unequal_teeth"]
    assert at == pytest.approx([0.02, 0.02])
    assert both.places == ()


@pytest.mark.parametrize(("measured", "shown"), [(True, [True, True]), (False, [True, False])])
def test_of_two_lines_that_are_smeared_into_each_other_the_first_has_the_power_of_both(measured, shown):
    speed = np.linspace(58.0, 66.0, int(0.75 * RATE))
    run = drawn_run(1, speed=speed, rate=RATE, orders={24.0: AMPLITUDE, 24.5: 0.5 * AMPLITUDE}, noise=1e-4)
    lines = line_powers(replace(run, has_encoder=measured), slice(0, speed.size), [order(24.0), order(24.5)])
    assert np.isfinite(lines.power).tolist() == shown
    both = AMPLITUDE**2 * (1.0 if measured else 1.25)
    assert lines.power[0] == pytest.approx(both, rel=0.2)
