"""A strong hum goes on while a signal is lost, and moves the level it is lost to: without it the moments are plain."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from torquerig.recordings.recording import Recording
from torquerig.recordings.repair import sharp_dropouts
from torquerig.recordings.repair.mains_hum import grid_line, without_hum
from torquerig.recordings.repair.sharp_dropouts import gaps
from torquerig.recordings.repair.strong_tone import power_of
from torquerig.scenario.model import Scenario

GRID = 49.961  # [Hz]
LENGTH = 460  # samples, near a period of the hum
AMPLITUDES = (0.25, 0.10, 0.11, 0.0, 0.03)  # [V]


@pytest.fixture(scope="module")
def clean(wear_rig: Scenario, record: Callable[..., Recording]) -> Recording:
    return record(wear_rig.rig, 3, duration=6.0)


def hum(recording: Recording) -> np.ndarray:
    time = np.arange(recording.samples) / recording.sample_rate
    return np.asarray(sum(size * np.cos(2 * np.pi * n * GRID * time + n) for n, size in enumerate(AMPLITUDES, start=1)))


@pytest.mark.parametrize("lost", [True, False])
def test_moments_without_signal_are_found_beneath_it(
    lost: bool, clean: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    volts, rate = clean.torque_values().copy(), clean.sample_rate
    starts = list(range(1500, volts.size - 2 * LENGTH, 20_000)) if lost else []
    for start in starts:
        volts[start : start + LENGTH] = volts.mean() - 1.0
    volts += hum(clean)
    assert [(start, stop - start) for start, stop, _ in gaps(volts, rate)] == [(start, LENGTH) for start in starts]
    monkeypatch.setattr(sharp_dropouts, "without_hum", lambda *_: None)
    assert len(gaps(volts, rate)) < max(len(starts), 1), "the hum hides some"


def test_it_is_taken_off_with_its_harmonics(clean: Recording) -> None:
    volts, rate = clean.torque_values(), clean.sample_rate
    still = without_hum(volts + hum(clean), rate)
    assert still is not None
    assert np.std(still - volts) < 0.06 * np.std(hum(clean)), "what the load has in the same waves goes with it"
    assert grid_line(*power_of(volts + hum(clean), rate)) == pytest.approx(GRID, abs=0.01)


def test_where_no_hum_stands_out_nothing_is_taken_off(clean: Recording) -> None:
    assert without_hum(clean.torque_values(), clean.sample_rate) is None
