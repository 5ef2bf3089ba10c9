"""Moments without signal are filled with the lines of the rest, and nothing else is touched."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np

from torquerig.diagnosis.looking.features import features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.refilled import refilled
from torquerig.inference.places import order

RATE, SAMPLES = 5000.0, 60_000
ANGLE = 2 * pi * 16.7 * np.arange(SAMPLES) / RATE
LOST = [(1000 + 9000 * row, 1165 + 9000 * row) for row in range(6)]  # 33 ms each
PLACES = [order(3.0), order(7.0)]
ByHand = Callable[..., Observed]


def spoilt(by_hand: ByHand) -> tuple[Observed, np.ndarray]:
    """A run of two lines in little noise with straight lines across its lost moments, and what was there."""
    rng = np.random.default_rng(8)
    torque = 0.3 + 0.1 * np.cos(3 * ANGLE) + 0.08 * np.cos(7 * ANGLE + 1) + 0.002 * rng.standard_normal(SAMPLES)
    bridged = torque.copy()
    for start, stop in LOST:
        bridged[start:stop] = np.linspace(torque[start - 1], torque[stop], stop - start)
    return by_hand(bridged, ANGLE, rate=RATE, name="run"), torque


def test_lines_go_on_through_lost_moments(by_hand: ByHand) -> None:
    run, torque = spoilt(by_hand)
    filled = refilled(run, LOST, PLACES).torque
    inside = np.concatenate([np.arange(start, stop) for start, stop in LOST])
    assert np.array_equal(np.delete(filled, inside), np.delete(run.torque, inside))
    assert np.std(filled[inside] - torque[inside]) < 2 * 0.002  # noise there and at the ends of the straight lines
    assert np.std(run.torque[inside] - torque[inside]) > 0.05


def test_no_corner_rings_through_the_bands(by_hand: ByHand) -> None:
    run, torque = spoilt(by_hand)
    whole, broken, filled = (
        features(each, PLACES).power for each in (replace(run, torque=torque), run, refilled(run, LOST, PLACES))
    )
    quiet = slice(10, None)
    assert np.nanmax(broken[quiet] / whole[quiet]) > 3
    assert np.nanmax(filled[quiet] / whole[quiet]) < 1.5  # 2 % of the noise has become straight lines


def test_a_run_without_lost_moments_is_the_same_object(by_hand: ByHand) -> None:
    run, _ = spoilt(by_hand)
    assert refilled(run, [], PLACES) is run
