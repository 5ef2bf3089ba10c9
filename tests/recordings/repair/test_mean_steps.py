"""Steps of the mean: found to some milliseconds, taken out, told, and never seen in loads, slopes, lines or starts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair.mean_steps import edges, mean_steps, without_steps
from torquerig.scenario.model import Scenario

RATE, START, STOP = 10_000.0, 31_000, 49_000  # [Hz], samples


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=8.0, rate=RATE)


@pytest.fixture(scope="module")
def ramp(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=8.0, rate=RATE, profile="ramp")


def volts_of(recording: Recording) -> np.ndarray:
    return recording.channels["torque_V"].values.copy()


def stepped(recording: Recording, height: float, *, rise: float = 0.005) -> Recording:
    time = np.arange(recording.samples) / RATE
    up, down = (np.clip((time - at / RATE) / rise, 0.0, 1.0) for at in (START, STOP))
    return recording.with_values("torque_V", volts_of(recording) + height * (up - down))


@pytest.mark.parametrize("height", [0.8, -1.5])
def test_a_step_up_and_down_is_found_and_taken_out(height: float, clean: Recording) -> None:
    spoilt = stepped(clean, height)
    (found,) = mean_steps([spoilt])
    assert [each.sample for each in found] == pytest.approx([START, STOP], abs=0.01 * RATE)
    assert [each.height for each in found] == pytest.approx([height, -height], abs=0.3)
    left = volts_of(without_steps(spoilt, found)) - volts_of(clean)
    outside = np.ones(clean.samples, dtype=bool)
    for start, stop in edges(spoilt, found):
        outside[start:stop] = False
    assert np.abs(left[outside]).max() < 0.3
    assert outside.mean() > 0.98


def test_clean_runs_have_none(clean: Recording, ramp: Recording) -> None:
    assert mean_steps([clean, ramp]) == ((), ())


def test_a_ramp_tells_nothing_alone(clean: Recording, ramp: Recording) -> None:
    assert mean_steps([stepped(ramp, 1.5)]) == ((),)
    assert mean_steps([clean, stepped(ramp, 1.5)]) == ((), ())
    _, along = mean_steps([stepped(clean, 1.5), stepped(ramp, 1.5)])
    assert [each.sample for each in along] == pytest.approx([START, STOP], abs=0.01 * RATE)


def test_the_ends_of_moments_without_signal_are_none(clean: Recording) -> None:
    assert mean_steps([stepped(clean, 1.5)], [[(START - 100, STOP + 100)]]) == ((),)


def test_what_takes_its_time_is_no_step(clean: Recording) -> None:
    assert mean_steps([stepped(clean, 1.5, rise=0.5)]) == ((),)


def test_what_rests_on_its_limit_is_not_asked(clean: Recording) -> None:
    """Three quarters of the samples stand on the limit; what lies below it for a moment seems to step."""
    spoilt = volts_of(stepped(clean, -1.5))
    limited = [clean.with_values("torque_V", np.minimum(spoilt, np.quantile(spoilt, part))) for part in (0.25, 0.95)]
    assert mean_steps(limited[:1]) == ((),)
    assert len(mean_steps(limited[1:])[0]) == 2


def test_a_strong_line_has_no_steps(clean: Recording) -> None:
    time = np.arange(clean.samples) / RATE
    for hertz in (1.3, 7.0, 50.0):
        tone = volts_of(clean) + 2.0 * np.sign(np.cos(2 * np.pi * hertz * time)) * np.abs(
            np.cos(2 * np.pi * hertz * time)
        )
        assert mean_steps([clean.with_values("torque_V", tone)]) == ((),)


def test_runs_that_turn_back_are_not_looked_at(clean: Recording) -> None:
    turning = replace(stepped(clean, 1.5), run=replace(clean.run, profile="reversal"))
    assert mean_steps([turning]) == ((),)


def test_a_signal_that_rests_on_one_code_and_moves_to_the_next_does_not_step(clean: Recording) -> None:
    volts = np.where(np.arange(clean.samples) < START, 0.0, 0.3)
    resting = clean.with_values("torque_V", volts)
    assert mean_steps([resting], resolution=0.15) == ((),)
    assert mean_steps([resting]) != ((),)
