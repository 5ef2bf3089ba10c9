"""Samples renewed more seldom than written are told by their rhythm; coarse codes and lost moments keep none."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.repair.held_samples import on_straight_lines, renewed_every
from torquerig.recordings.repair.time_base import broken_time

RATE = 10_000.0


def of(volts: np.ndarray) -> Recording:
    return Recording(
        name="run", channels={"torque_V": Channel(values=volts, quantity="torque", unit="V")}, sample_rate=RATE
    )


@pytest.fixture(scope="module")
def smooth() -> np.ndarray:
    time = np.arange(40_000) / RATE
    return np.sin(2 * np.pi * 7.3 * time) + 0.01 * np.random.default_rng(5).standard_normal(time.size)


@pytest.mark.long
@pytest.mark.parametrize("every", [2.0, 5.0, 12.34, 55.08])
def test_a_rhythm_is_told_whole_or_not(every: float, smooth: np.ndarray) -> None:
    at = (np.floor(np.arange(smooth.size) / every) * every).astype(int)
    held = of(smooth[at])
    assert renewed_every([held])[0] == pytest.approx(every, rel=1e-3)
    found = broken_time([held], renewed=renewed_every([held]))
    (fault,) = found.told
    sentence, place = fault.sentence, fault.place
    assert found.names == ("run",)
    assert "renewed only every" in sentence
    assert place.at == pytest.approx(RATE / every, rel=1e-3)
    if every > 5:
        slow = np.convolve(smooth, np.ones(400) / 400, "same")
        again = np.convolve(
            on_straight_lines(held, renewed_every([held])[0]).channels["torque_V"].values, np.ones(400) / 400, "same"
        )
        assert np.abs(again - slow)[1000:-1000].max() < 0.02


def test_a_rhythm_is_told_under_the_noise_of_what_comes_behind(smooth: np.ndarray) -> None:
    at = (np.floor(np.arange(smooth.size) / 10.7) * 10.7).astype(int)
    noise = 2e-4 * np.random.default_rng(6).standard_normal(smooth.size)
    held = of(smooth[at] + noise)
    assert renewed_every([held])[0] == pytest.approx(10.7, rel=1e-3)
    lines = on_straight_lines(held, renewed_every([held])[0]).channels["torque_V"].values
    assert np.mean(np.diff(lines) == 0) < 0.01  # where two renewals are alike nothing stands still all the same
    assert np.abs(lines - smooth)[1000:-1000].std() < 0.8 * np.abs(held.channels["torque_V"].values - smooth).std()


def test_what_is_not_held_keeps_none(smooth: np.ndarray) -> None:
    lost = smooth.copy()
    lost[3000:23_000] = 0.0  # half of it, at one level
    coarse, slow = 0.2 * np.round(smooth / 0.2), 0.5 * np.round(np.cumsum(smooth) / 50)
    struck = smooth + 0.3 * (np.arange(smooth.size) % 100 < 2)  # twice a beat: up and down again
    seldom = smooth + 0.3 * (np.arange(smooth.size) % 400 < 200)
    for volts in (smooth, coarse, slow, lost, np.zeros(5000), struck, seldom):
        recording = of(volts)
        assert renewed_every([recording]) == [None]
        assert on_straight_lines(recording, None) is recording


@pytest.mark.long
@pytest.mark.parametrize("every", [10.7, 22.88])
def test_a_rhythm_that_one_run_tells_is_found_where_steps_hardly_pass_the_noise(every: float) -> None:
    time = np.arange(40_000) / RATE
    at = (np.floor(np.arange(time.size) / every) * every).astype(int)
    noise = 0.02 * np.random.default_rng(8).standard_normal(time.size)
    clear, faint = (size * np.sin(2 * np.pi * 37.3 * time) for size in (20.0, 0.2))
    alone, both = renewed_every([of(faint[at] + noise)]), renewed_every([of(clear[at] + noise), of(faint[at] + noise)])
    assert alone == [None]
    assert both == pytest.approx([every, every], rel=3e-4)
    assert renewed_every([of(clear[at] + noise), of(faint + noise)])[1] is None
    lines = on_straight_lines(of(faint[at] + noise), both[1]).channels["torque_V"].values
    assert (
        np.abs(lines - faint)[100:-100].max() < 0.06
    )  # of what is held the noise's mean stays, and the way to the next


def test_a_limit_that_is_left_once_a_turn_is_no_rhythm() -> None:
    time = np.arange(40_000) / RATE
    volts = 1.0 - 1.3 * np.clip(np.cos(2 * np.pi * 22.25 * time) - 0.97, 0.0, None)
    assert np.mean(volts == 1.0) > 0.5
    assert renewed_every([of(np.where(volts < 1.0, np.round(volts, 1), volts))]) == [None]
