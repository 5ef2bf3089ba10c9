"""What fills a band with a spectrum of its own is forgiven there, and nothing elsewhere."""

from __future__ import annotations

from collections.abc import Callable
from math import log
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from torquerig.diagnosis.case import Case
from torquerig.diagnosis.expecting.added_signals import rung_by
from torquerig.diagnosis.expecting.expectation import expected
from torquerig.diagnosis.fitting.misfit import BAND_TOLERANCE
from torquerig.diagnosis.judging.forgiven_bands import forgiven
from torquerig.diagnosis.looking.features import Features, features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.linear_twin.twin import Twin
from torquerig.mechanisms import BearingDefect
from torquerig.rig.assembly import Rig
from torquerig.scenario.model import Scenario

RING = 800.0
BEARING = BearingDefect(name="bearing_defect", order_output=4.6, ring_frequency=RING, damping=0.02, amplitude=0.8)


@pytest.fixture(scope="module")
def seen(wear_rig: Scenario, by_hand: Callable[..., Observed]) -> Features:
    rate, samples = 5000.0, 30_000
    angle = 2 * np.pi * 16.7 * np.arange(samples) / rate
    run = by_hand(0.01 * np.random.default_rng(3).standard_normal(samples), angle, rate=rate)
    return features(run, [])


def held(rig: Rig) -> Case:
    return cast("Case", SimpleNamespace(model=SimpleNamespace(rig=rig)))


def test_a_ring_far_from_its_mode_may_be_ten_decibels_off(wear_rig: Scenario, seen: Features) -> None:
    """A share s of the density that is a factor k off moves the logarithm of the whole by log(1 + s (k - 1))."""
    rig = wear_rig.rig + BEARING
    rung = next(iter(rung_by(Twin(rig.at(seen.observed.run)), seen)))[1]
    share = rung / expected(rig, seen).power
    idle = wear_rig.rig.at(seen.observed.run)
    load = Twin(idle).load_power_between(*seen.band_edges) / expected(rig, seen).power
    at = int(np.argmin(np.abs(seen.band - RING / 5)))  # more than an octave below, where the bound of 10 dB holds
    tight = 1 / float(seen.count[at]) + BAND_TOLERANCE**2
    for sign, moved in ((1.0, log(1 + share[at] * (np.exp(2.3) - 1))), (-1.0, log(1 - share[at] * (1 - np.exp(-2.3))))):
        loose = moved**2 + (0.35 * min(load[at], 1.0)) ** 2
        left = forgiven(held(rig), seen, np.full(seen.band.size, sign * 10.0))
        assert left[at] == pytest.approx(sign * 10 * np.sqrt(tight / (tight + loose)), rel=1e-6)
        assert abs(left[at]) < 8


def test_where_neither_a_load_nor_a_ring_is_nothing_is_forgiven(wear_rig: Scenario, seen: Features) -> None:
    left = forgiven(held(wear_rig.rig), seen, np.full(seen.band.size, 10.0))
    assert left[seen.band > 2000] == pytest.approx(10.0, rel=1e-3)
