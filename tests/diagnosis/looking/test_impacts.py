"""Impacts that ring: the order at which they strike, whatever the shaft does to their strength."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.diagnosis.looking.impacts import _Beats, _fundamental, impact_orders
from torquerig.diagnosis.looking.observed import Observed
from torquerig.inference.places import order

RATE, LENGTH, RATIO = 10_000.0, 12.0, 5.0
TIME = np.arange(int(RATE * LENGTH)) / RATE
KNOWN = [order(each / RATIO) for each in (1, 2, 3, 5)]
ByHand = Callable[..., Observed]


def struck(by_hand: ByHand, order_output: float, *, swing: float = 0.0, every: int = 1, seed: int = 1) -> Observed:
    """Rings of 1.5 kHz at an order of the output shaft, each ``every``th the strongest, all swinging once a turn."""
    rng = np.random.default_rng(seed)
    speed = 100.0 + 10.0 * seed
    moments = np.arange(0.01, LENGTH, 2 * pi * RATIO / order_output / speed)
    strength = 0.3 * (1 + swing * np.cos(speed * moments / RATIO + 0.4))
    strength[np.arange(moments.size) % every > 0] *= 0.3
    torque = 1.0 + 0.02 * rng.standard_normal(TIME.size)
    ring = np.arange(int(0.02 * RATE)) / RATE
    wave = np.exp(-0.05 * 2 * pi * 1500 * ring) * np.sin(2 * pi * 1500 * ring)
    for at, size in zip((moments * RATE).astype(int).tolist(), strength.tolist(), strict=True):
        torque[at : at + wave.size] += size * wave[: torque.size - at]
    return by_hand(torque, speed * TIME, rate=RATE, name=f"run{seed}")


@pytest.mark.parametrize("order_output", [3.0777, 2.8688, 5.91])
@pytest.mark.parametrize("swing", [0.0, 0.5])
def test_the_order_of_the_impacts_is_told(order_output: float, swing: float, by_hand: ByHand) -> None:
    """A third of 3.08 lies within a bin of the shaft's own order, and its multiples beside those of the swing."""
    runs = [struck(by_hand, order_output, swing=swing, seed=seed) for seed in (1, 2)]
    clearest = impact_orders(runs, KNOWN)[0]
    assert RATIO * clearest.motor_order == pytest.approx(order_output, abs=0.02)


def test_the_lowest_order_is_told_where_every_third_impact_is_the_strongest(by_hand: ByHand) -> None:
    runs = [struck(by_hand, 7.95, every=3, seed=seed) for seed in (1, 2)]
    assert RATIO * impact_orders(runs, KNOWN)[0].motor_order == pytest.approx(7.95 / 3, abs=0.02)


@pytest.mark.parametrize(("below", "told"), [(0.3, 0.859), (1.5, 1.718)])
def test_what_is_as_strong_as_the_order_itself_is_no_side_line_of_it(below: float, told: float) -> None:
    """Short runs do not resolve 4.295 output orders from a side line of 8.59, which has a quarter of its power."""
    step = 0.015
    log = np.zeros(2000)
    for multiple in range(1, 8):
        at = round(multiple * 0.859 / step)
        log[at - 1 : at + 2] = 6.0 - (below if multiple % 2 else 0.0)
    assert _fundamental([_Beats(log, step, 100.0)], 1.718, KNOWN) == pytest.approx(told)


@pytest.mark.parametrize("same_rate", [False, True])
def test_impacts_that_keep_their_rate_at_every_speed_are_no_bearings(same_rate: bool, by_hand: ByHand) -> None:
    """A telephone beats 217 times a second however fast the shaft turns, and clear runs of one speed outvote others."""
    orders = [3.0777 * (130.0 / (100.0 + 10.0 * seed) if same_rate else 1.0) for seed in (3, 3, 6)]
    runs = [struck(by_hand, each, seed=seed) for each, seed in zip(orders, (3, 3, 6), strict=True)]
    assert bool(impact_orders(runs, KNOWN)) is not same_rate
