"""A tone that was looked at as an order: its frequency to the hundredth of a bin, and its place in what is judged."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.calibration import Calibrated, misfits_of
from torquerig.diagnosis.fitting.misfit import misfit_sum
from torquerig.diagnosis.judging.fixed_after_all import looked_at_as_found
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.steady_tone import steady_frequency
from torquerig.inference.places import frequency, order
from torquerig.mechanisms import PwmAliasing
from torquerig.scenario.model import Scenario

RATE, LENGTH, TONE = 5000.0, 12.0, 837.24
TIME = np.arange(int(RATE * LENGTH)) / RATE
ANGLE = 100.0 * TIME + 0.02 * np.sin(2 * pi * 0.3 * TIME)
ByHand = Callable[..., Observed]


@pytest.fixture
def run(by_hand: ByHand) -> Observed:
    noise = 2e-3 * np.random.default_rng(4).standard_normal(TIME.size)
    torque = 1.0 + 0.05 * np.cos(2 * pi * TONE * TIME + 0.4) + noise
    return by_hand(torque, ANGLE, rate=RATE, measured=False)


@pytest.mark.parametrize("off", [-0.9, 0.0, 1.3])
def test_the_frequency_is_read_off_the_tallest_line(off: float, run: Observed) -> None:
    assert steady_frequency(run, TONE + off) == pytest.approx(TONE, abs=0.02 / (LENGTH * 4 / 6))


def test_a_tone_is_judged_where_it_stands(run: Observed, wear_rig: Scenario) -> None:
    as_order, as_tone, native = order(round(TONE / 100.0 * 2 * pi, 1)), frequency(TONE), order(7.0)
    places = [native, as_order]
    seen, held = (features(run, places, held=part, unknown=[as_order]) for part in (False, True))
    part = PwmAliasing(name="pwm_aliasing", frequency=TONE, amplitude=0.05)
    rig = wear_rig.rig.at(run.run) + part
    model = Calibrated(rig, (), np.zeros(0), np.zeros((0, 0)), misfits_of(rig, [seen]), 0.0)
    tone = Candidate(mechanism="pwm_aliasing", parts=(part,), knobs=(), place=as_tone)
    case = Case(nominal=wear_rig.rig, runs=(run,), seen=(seen,), model=model, left=(), accepted=(tone,))
    judged, (unseen,) = looked_at_as_found(case, [held])
    for one in (judged.seen[0], unseen):
        assert one.places == (native, as_tone)
        assert one.unknown == (as_tone,)
        assert np.abs(one.amplitude[:, 1]) == pytest.approx(0.05, rel=0.02)
        assert expected(rig, one).amplitude[:, 1] == pytest.approx(0.05 * run.torque_unit, rel=0.1)
    assert unseen.held is True
    assert judged.model.cost == pytest.approx(misfit_sum(judged.model.misfits))


def test_nothing_changes_where_every_line_stands_in_its_domain(run: Observed, wear_rig: Scenario) -> None:
    seen, held = (features(run, [order(7.0), frequency(TONE)], held=part) for part in (False, True))
    model = Calibrated(wear_rig.rig, (), np.zeros(0), np.zeros((0, 0)), (), 0.0)
    tone = Candidate(mechanism="pwm_aliasing", parts=(), knobs=(), place=frequency(TONE))
    turning = replace(tone, place=order(133.0))
    for accepted in ((), (tone,), (turning,)):
        case = Case(nominal=wear_rig.rig, runs=(run,), seen=(seen,), model=model, left=(), accepted=accepted)
        judged, (unseen,) = looked_at_as_found(case, [held])
        assert judged is case
        assert unseen is held


def test_a_tone_at_the_end_of_the_spectrum_is_read_too(by_hand: ByHand) -> None:
    end = 0.5 * RATE - 0.3
    run = by_hand(1.0 + 0.05 * np.cos(2 * pi * end * TIME), ANGLE, rate=RATE, measured=False)
    assert steady_frequency(run, end) == pytest.approx(end, abs=0.2)
