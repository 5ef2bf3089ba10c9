"""A multiple of an effect's order, small beside its own line, is the detail of its law; a large one is left."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.diagnosis.case import Candidate, Case
from torquerig.diagnosis.fitting.calibration import Calibrated
from torquerig.diagnosis.fitting.misfit import Misfit
from torquerig.diagnosis.judging.leftover import mismatches
from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import Place, frequency, order
from torquerig.mechanisms import BearingDefect
from torquerig.scenario.model import Scenario

RATE, SAMPLES = 2000.0, 24_000
ANGLE = 2 * np.pi * 16.7 * np.arange(SAMPLES) / RATE
PLACES = [order(2.6), order(5.2), order(10.4), order(11.0), frequency(950.0), order(80.0)]
ByHand = Callable[..., Observed]


def left_orders(
    by_hand: ByHand, wear_rig: Scenario, *, second: float, accepted: Place | None, impacts: float | None = None
) -> list[float]:
    """Orders that are left of a line of 1 at order 5.2, of ``second`` at twice it and of 0.03 at order 11."""
    torque = np.cos(5.2 * ANGLE) + second * np.cos(10.4 * ANGLE) + 0.03 * np.cos(11 * ANGLE)
    run = by_hand(torque + 1e-3 * np.random.default_rng(3).standard_normal(SAMPLES), ANGLE, rate=RATE, name="run")
    seen = features(run, PLACES)
    none = np.zeros(0)
    lines = np.array([0.0, 0.0, 9.0, 9.0, 0.0, 0.0])
    model = Calibrated(wear_rig.rig, (), none, np.zeros((0, 0)), (Misfit(none, lines, none),), 100.0)
    seen = replace(seen, power=none, band=none, width=none, count=none)
    found = Candidate(mechanism="blade_pass", parts=(), knobs=(), place=accepted)
    if impacts is not None:
        bearing = BearingDefect(name="bearing_defect", order_output=impacts, ring_frequency=900.0, amplitude=0.1)
        found = Candidate(mechanism="bearing_defect", parts=(bearing,), knobs=())
        model = replace(model, rig=model.rig + bearing)
    case = Case(nominal=wear_rig.rig, runs=(run,), seen=(seen,), model=model, left=(), accepted=(found,))
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # a place that no stretch shows is no reason to warn
        left = mismatches(case)
    return [mismatch.at / (5.0 if mismatch.axis == "output_shaft" else 1.0) for mismatch in left]


@pytest.mark.parametrize(("second", "left"), [(0.03, [11.0]), (0.2, [10.4, 11.0])])
def test_small_multiples_go_with_their_effect(
    second: float, left: list[float], by_hand: ByHand, wear_rig: Scenario
) -> None:
    found = left_orders(by_hand, wear_rig, second=second, accepted=order(5.2))
    assert sorted(found) == pytest.approx(left)


@pytest.mark.parametrize("place", [None, order(2.7), frequency(5.2)])
def test_what_is_no_multiple_of_a_found_line_is_left(place: Place | None, by_hand: ByHand, wear_rig: Scenario) -> None:
    found = left_orders(by_hand, wear_rig, second=0.03, accepted=place)
    assert sorted(found) == pytest.approx([10.4, 11.0])


@pytest.mark.parametrize(("impacts", "left"), [(6.5, [11.0]), (5.0, [10.4]), (3.7, [10.4, 11.0]), (6.6, [10.4, 11.0])])
def test_multiples_of_impacts_go_with_the_bearing_however_large(
    impacts: float, left: list[float], by_hand: ByHand, wear_rig: Scenario
) -> None:
    """Behind 5:1 the eighth multiple of 6.5 a turn stands at order 10.4 of the motor, the eleventh of 5 at 11."""
    found = left_orders(by_hand, wear_rig, second=0.2, accepted=None, impacts=impacts)
    assert sorted(found) == pytest.approx(left)
