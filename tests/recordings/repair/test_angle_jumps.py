"""Jumps of a measured angle: found to the sample where the clock jumps, and never where a shaft only turns."""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.angle_jumps import angle_jumps
from torquerig.scenario.model import Scenario

COUNTER = "encoder_count"
LOST = 100  # samples: 20 ms


@pytest.fixture(scope="module")
def turning(wear_rig: Scenario, record: Callable[..., Recording]) -> dict[str, Recording]:
    return {
        profile: record(wear_rig.rig, 5, duration=4.0, profile=profile) for profile in ("steady", "ramp", "reversal")
    }


def as_counts(recording: Recording) -> Recording:
    """The same with the channel's counts, whole as a counter gives them."""
    name = next(name for name, one in recording.channels.items() if one.quantity == "motor_angle")
    return recording.with_values(name, np.floor(recording.channels[name].values))


def counter_of(recording: Recording) -> str:
    return next(name for name, one in recording.channels.items() if one.quantity == "motor_angle")


@pytest.mark.parametrize("profile", ["steady", "ramp", "reversal"])
def test_a_shaft_that_turns_has_no_jumps(profile: str, turning: dict[str, Recording]) -> None:
    assert angle_jumps(turning[profile]) == ()
    assert angle_jumps(as_counts(turning[profile])) == ()


@pytest.mark.parametrize("where", [3000, 12000])
def test_lost_samples_are_found_where_they_are_missing(where: int, turning: dict[str, Recording]) -> None:
    recording = turning["steady"]
    name = counter_of(recording)
    values = recording.channels[name].values
    late = np.concatenate([values[: where + 1], values[where + 1 + LOST :], values[-1] + np.arange(LOST)])
    (found,) = angle_jumps(recording.with_values(name, late))
    assert found.start == where
    speed = 1000.0 * pi / 30
    assert found.turn == pytest.approx(LOST / recording.sample_rate * speed, rel=0.05)


def test_a_reading_that_is_wrong_once_is_no_jump(turning: dict[str, Recording]) -> None:
    recording = turning["steady"]
    name = counter_of(recording)
    values = recording.channels[name].values.copy()
    values[7000] += 500.0
    assert angle_jumps(recording.with_values(name, values)) == ()
