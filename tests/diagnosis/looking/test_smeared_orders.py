"""A line so smeared that no peak is left of it is told by moving with the speed; a mode of that width stays."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest
from scipy.signal import lfilter

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.peaks import peaks
from torquerig.diagnosis.looking.smeared_orders import smeared_orders

RATE, SAMPLES = 5000.0, 60_000
RATIO = 5.0


def course(speed: float, seed: int) -> np.ndarray:
    """An angle [rad] whose speed [rad/s] strays by one per cent within some hundredths of a second."""
    pull = np.random.default_rng(seed).standard_normal(SAMPLES)
    slow = lfilter([1.0], [1.0, -(1 - 2 * pi * 10.0 / RATE)], pull)
    return np.asarray(np.cumsum(speed * (1 + 0.01 * slow / slow.std())) / RATE)


@pytest.fixture(scope="module")
def two_runs(by_hand: Callable[..., Observed]) -> Callable[..., list[Observed]]:
    def made(wave: Callable[[np.ndarray, int], np.ndarray], *, measured: bool = False) -> list[Observed]:
        runs = []
        for seed, speed in ((1, 52.0), (2, 47.0)):
            angle = course(speed, seed)
            noise = 0.02 * np.random.default_rng(10 + seed).standard_normal(SAMPLES)
            # nobody measured the angle: it is taken to turn evenly
            even = np.linspace(angle[0], angle[-1], SAMPLES)
            runs.append(by_hand(wave(angle, seed) + noise, even, rate=RATE, name=f"{speed:g}", measured=measured))
        return runs

    return made


def mode(_: np.ndarray, seed: int) -> np.ndarray:
    """Noise through a mode of 480 Hz, some per cent wide."""
    pole = np.exp((-0.015 + 1j) * 2 * pi * 480.0 / RATE)
    driven = lfilter(
        [1.0], [1.0, -2 * pole.real, abs(pole) ** 2], np.random.default_rng(30 + seed).standard_normal(SAMPLES)
    )
    return np.asarray(0.1 * driven / driven.std())


@pytest.mark.parametrize("order", [60.0, 38.4])
def test_a_smeared_line_is_told_by_moving_with_the_speed(order: float, two_runs: Callable[..., list[Observed]]) -> None:
    runs = two_runs(lambda angle, _: 0.1 * np.cos(order * angle))
    assert not [peak for peak in peaks(runs, []) if peak.speeds > 1], "no peak stands out"
    assert smeared_orders(runs, [], ratio=RATIO) == pytest.approx((order,))


def test_a_mode_stays_where_it_is(two_runs: Callable[..., list[Observed]]) -> None:
    assert smeared_orders(two_runs(mode), [], ratio=RATIO) == ()


def test_a_mode_beside_a_line_hides_it_not(two_runs: Callable[..., list[Observed]]) -> None:
    runs = two_runs(lambda angle, seed: mode(angle, seed) + 0.1 * np.cos(30.0 * angle))
    assert smeared_orders(runs, [], ratio=RATIO) == (30.0,)


def test_noise_has_no_order(two_runs: Callable[..., list[Observed]]) -> None:
    assert smeared_orders(two_runs(lambda angle, _: np.zeros(angle.size)), [], ratio=RATIO) == ()


def test_a_known_order_and_a_measured_angle_need_not_be_told(two_runs: Callable[..., list[Observed]]) -> None:
    def wave(angle: np.ndarray, _: int) -> np.ndarray:
        return np.asarray(0.1 * np.cos(60.0 * angle))

    assert smeared_orders(two_runs(wave), [60.0], ratio=RATIO) == ()
    assert smeared_orders(two_runs(wave, measured=True), [], ratio=RATIO) == ()
