"""Lines of a run whose angle was not measured: what the angle does not follow makes them wider than a bin."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run
from torquerig.inference.features.line_powers import line_powers
from torquerig.inference.places import order

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
