"""Lines that turn with a shaft: how surely they stand out of noise along the motor's angle."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import exp

import numpy as np
import pytest
from scipy.stats import kstest

from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.orders_standing_out import chances_of_orders, taken_together, turns_of
from torquerig.diagnosis.opening import followed
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

ORDERS = [0.23, 0.41, 0.67]


@pytest.fixture(scope="module")
def run(wear_rig: Scenario, record: Callable[..., Recording]) -> Observed:
    recordings = [record(wear_rig.rig, 3, duration=8.0)]
    (followed_run,) = followed(recordings, recordings, wear_rig.rig)
    return followed_run


def noisy(run: Observed, seed: int, line: float = 0.0, at: float = ORDERS[0]) -> Observed:
    noise = np.random.default_rng(seed).normal(0.0, 1.0, run.torque.size)
    return replace(run, torque=0.7 + noise + line * np.cos(at * run.angle + 1.0))


def test_noise_alone_gives_every_chance_alike(run: Observed) -> None:
    """Uniform between 0 and 1, of single orders and of all taken together."""
    each = [chances_of_orders(noisy(run, seed), ORDERS) for seed in range(60)]
    assert kstest(np.concatenate(each), "uniform").pvalue > 0.01
    assert kstest([taken_together(chances) for chances in each], "uniform").pvalue > 0.01


def test_a_line_stands_out_by_its_power_over_the_noise_of_a_bin(run: Observed) -> None:
    """A^2 n / 6 s^2 under a Hann window, whose noise is 1.5 bins wide; so many others stand beside it."""
    line = 0.06
    chances = [chances_of_orders(noisy(run, seed, line), ORDERS)[0] for seed in range(40)]
    ratio = 20 * np.expm1(-np.log(chances) / 20)
    assert np.median(ratio) == pytest.approx(1 + line**2 * run.torque.size / 6, rel=0.15)


def test_a_line_beside_is_no_chance(run: Observed) -> None:
    """A strong line four bins off hides a weak one where it is taken for noise, and not where it is known."""
    beside = ORDERS[0] + 4 / turns_of(run)
    made = noisy(run, 1, line=0.08)
    both = replace(made, torque=made.torque + 2.0 * np.cos(beside * run.angle))
    assert chances_of_orders(both, ORDERS[:1])[0] > 0.01
    assert chances_of_orders(both, ORDERS[:1], others=[beside])[0] < 1e-4


def test_what_a_run_cannot_show_says_nothing(run: Observed) -> None:
    """Two bins above standstill, or faster than the torque is looked at."""
    assert chances_of_orders(run, [2 / turns_of(run), 5000.0]) == []
    assert taken_together([]) == 1.0


def test_fisher_takes_chances_together() -> None:
    """Of two, p q (1 - ln p q)."""
    assert taken_together([0.1, 0.1]) == pytest.approx(0.01 * (1 - np.log(0.01)))
    assert taken_together([exp(-3)]) == pytest.approx(exp(-3))
