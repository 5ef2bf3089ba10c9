"""A line that sweeps: found with its ends to a tenth of a hertz, taken out, and never seen in tones or orders."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.path_sum import largest_path_sum
from torquerig.recordings.repair.sweep_course import Sweep, without_sweep
from torquerig.recordings.repair.sweeps import CLEAR, sweep_along, sweeps_in
from torquerig.scenario.model import Scenario

RATE, LENGTH = 5000.0, 8.0
TIME = np.arange(int(RATE * LENGTH)) / RATE


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=LENGTH, rate=RATE)


def volts_of(recording: Recording) -> np.ndarray:
    return recording.channels["torque_V"].values.copy()


def sweeping(start: float, stop: float, volts: float) -> np.ndarray:
    return volts * np.cos(2 * pi * (start * TIME + 0.5 * (stop - start) / LENGTH * TIME**2) + 0.7)


@pytest.mark.parametrize(("start", "stop"), [(300.0, 520.0), (1490.0, 410.0)])
@pytest.mark.parametrize("volts", [0.02, 0.3])
def test_a_sweep_is_found_and_taken_out(start: float, stop: float, volts: float, clean: Recording) -> None:
    line = sweeping(start, stop, volts)
    spoilt = volts_of(clean) + line
    found = sweeps_in([(spoilt, RATE)])[0]
    assert found is not None
    assert (found.start, found.stop) == pytest.approx((start, stop), abs=0.2)
    left = without_sweep(spoilt, RATE, found) - volts_of(clean)
    # the torque's own noise within a hertz of the line goes with it
    assert np.std(left) < 0.1 * np.std(line) + 0.1 * np.std(volts_of(clean))
    assert sweeps_in([(without_sweep(spoilt, RATE, found), RATE)])[0] is None


def test_what_keeps_its_frequency_or_its_order_is_no_sweep(clean: Recording) -> None:
    volts = volts_of(clean)
    assert sweeps_in([(volts, RATE)])[0] is None
    tone = 0.3 * np.cos(2 * pi * 731.0 * TIME)
    bursts = tone * (np.sin(2 * pi * 0.9 * TIME) > 0.7)
    wandering = 0.3 * np.cos(2 * pi * 1300.0 * TIME + 20.0 * np.sin(2 * pi * 0.2 * TIME))  # 4 Hz, as of an uneven speed
    faster = 0.3 * np.cos(2 * pi * (1300.0 * TIME + 0.5 * 50.0 / LENGTH * TIME**2))  # 4 % in the run, as of a motor
    for added in (tone, bursts, wandering, faster):
        assert sweeps_in([(volts + added, RATE)])[0] is None
    assert sweeps_in([(volts[: int(2 * RATE)], RATE)])[0] is None


def test_a_faint_sweep_is_told_by_several_runs_together() -> None:
    noises = [0.01 * np.random.default_rng(seed).standard_normal(TIME.size) for seed in (1, 2, 3)]
    line = sweeping(600.0, 251.0, 0.0015)
    for alone in noises:
        assert sweeps_in([(alone + line, RATE)]) == [None]
    for found in sweeps_in([(noise + line, RATE) for noise in noises]):
        assert found is not None
        assert found.clear < CLEAR
        assert (found.start, found.stop) == pytest.approx((600.0, 251.0), abs=0.5)
    assert sweeps_in([(noise, RATE) for noise in noises]) == [None] * 3
    assert sweeps_in([(noises[0] + line, RATE), *((noise, RATE) for noise in noises[1:])]) == [None] * 3


def test_in_a_ramp_only_the_sweep_of_other_runs_is_looked_for() -> None:
    noise = 0.01 * np.random.default_rng(1).standard_normal(TIME.size)
    order = sweeping(0.0, 900.0, 0.2)
    known = Sweep(600.5, 250.0, 30.0)
    assert sweep_along(noise + order, RATE, [known]) is None
    found = sweep_along(noise + order + sweeping(600.0, 251.0, 0.02), RATE, [Sweep(900.0, 1000.0, 20.0), known])
    assert found is not None
    assert (found.start, found.stop) == pytest.approx((600.0, 251.0), abs=0.2)
    assert sweep_along(noise + order, RATE, []) is None


def test_the_largest_path_of_a_grid_is_found_by_trying_all() -> None:
    values = np.random.default_rng(3).standard_normal((7, 11))
    every = {
        (start, stop): sum(values[row, int(start + (stop - start) * row / 6 + 0.5)] for row in range(7))
        for start in range(11)
        for stop in range(11)
        if abs(stop - start) >= 3
    }
    start, stop = max(every, key=lambda ends: every[ends])
    assert largest_path_sum(values, 3) == (pytest.approx(every[start, stop]), start, stop)
