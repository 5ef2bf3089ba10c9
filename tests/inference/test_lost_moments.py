"""Moments without a signal: neither a line nor what is left of it may change where they are bridged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from torquerig.inference.features.run_features import run_features
from torquerig.inference.places import order

NOISE, RATE = 0.1, 2000.0  # [N m], [Hz]


@pytest.mark.parametrize("lost", [0.02, 0.06], ids=["2 %", "6 %"])
@pytest.mark.parametrize("speed", [steady(1000), ramp(3000)], ids=["steady", "ramp"])
def test_moments_without_signal_leave_neither_less_of_a_line_nor_its_negative(speed, lost):
    plain = drawn_run(7, speed=speed, orders={7.0: 3.0}, noise=NOISE)
    flags = np.zeros(speed.size, dtype=bool)
    for start in np.random.default_rng(8).integers(0, speed.size - 40, int(lost * speed.size / 40)):
        flags[start : start + 40] = True
    shown = np.flatnonzero(~flags)
    bridged = np.interp(np.arange(speed.size), shown, plain.torque[shown])
    whole = run_features(plain, [order(7.0)])
    seen = run_features(replace(plain, torque=bridged, lost=flags), [order(7.0)])
    assert seen.lines.power == pytest.approx(whole.lines.power, rel=0.02, nan_ok=True)
    enough = whole.band_count > 10
    changed = np.log(seen.band_power[enough] / whole.band_power[enough])
    assert np.abs(changed * np.sqrt(whole.band_count[enough])).max() < 3  # the negative of the line: some 100
    assert abs(np.median(changed)) < 2 * lost
    assert np.abs(seen.level - whole.level).max() < 5 * NOISE / np.sqrt(seen.level_duration.min() * RATE)
