"""A run whose speed is off by another share than its neighbours' is followed along its own lines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.inference.motor_angle.shaft_angle import shaft_angles
from torquerig.inference.motor_angle.speed_factor import speed_factor
from torquerig.recordings.recording import Recording
from torquerig.scenario.model import Scenario

OFF = 1.004  # of every run that is made here
RATE = 2000.0


def asked_less(recording: Recording, factor: float) -> Recording:
    """Return the recording with a sheet that asks for less by a factor than the drive was told."""
    speed = recording.run.speed
    assert speed is not None
    return replace(recording, run=replace(recording.run, speed=speed / factor))


@pytest.mark.long
@pytest.mark.parametrize("profile", ["ramp", "reversal"])
@pytest.mark.parametrize("own", [1.0, 1.005, 0.987])
def test_a_moving_run_has_its_own_error(
    own: float, profile: str, wear_rig: Scenario, record: Callable[..., Recording]
) -> None:
    steady = record(wear_rig.rig, 3, encoder=False)
    moving = asked_less(record(wear_rig.rig, 4, profile=profile, occupancy=0.0, duration=8.0, encoder=False), own)
    first, second = shaft_angles([steady, moving], wear_rig.rig)
    assert first.factor == pytest.approx(OFF, abs=3e-4)
    assert second.factor == pytest.approx(OFF * own, abs=9e-4)  # a speed loop follows a reversal to a few of 10000
    assert not second.measured


def test_so_has_a_steady_one_and_its_neighbours_keep_theirs(
    wear_rig: Scenario, record: Callable[..., Recording]
) -> None:
    runs = [record(wear_rig.rig, seed) for seed in (3, 4)]
    other = asked_less(record(wear_rig.rig, 5, rpm=700.0), 1.005)
    told = [angle.factor for angle in shaft_angles([*runs, other], wear_rig.rig)]
    assert told == pytest.approx([OFF, OFF, OFF * 1.005], abs=3e-4)


def swept(orders: tuple[float, ...], factor: float, noise: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the torque of a run that speeds up, its lines turning ``factor`` times as fast as the angle beside it."""
    time = np.arange(round(10 * RATE)) / RATE
    angle = 2 * np.pi * (4.0 * time + 2.0 * time**2)
    torque = noise * np.random.default_rng(7).standard_normal(time.size)
    return torque + sum((0.05 * np.cos(order * factor * angle + order) for order in orders), np.zeros(1)), angle


@pytest.mark.parametrize("factor", [0.99, 1.0, 1.006])
def test_lines_tell_how_fast_the_shaft_turns(factor: float) -> None:
    torque, angle = swept((6.0, 7.0), factor, noise=0.1)
    assert speed_factor(torque, RATE, angle, (1.0, 6.0, 7.0), expected=1.0) == pytest.approx(factor, abs=4e-4)


def test_where_no_line_stands_out_nothing_is_told() -> None:
    for orders in ((), (6.5,)):
        torque, angle = swept(orders, 1.0, noise=0.1)
        assert speed_factor(torque, RATE, angle, (6.0, 7.0, 12.0), expected=1.0) == 1.0
    assert speed_factor(np.zeros(20000), RATE, angle, (6.0, 7.0), expected=1.0) == 1.0


def test_no_set_point_is_off_by_more_than_a_percent_or_so() -> None:
    torque, angle = swept((6.0, 7.0), 1.012, noise=0.1)
    assert speed_factor(torque, RATE, angle, (6.0, 7.0), expected=1.01) == 1.0
