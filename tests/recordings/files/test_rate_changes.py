"""Two rates in one column of times are named, refused for work, and joined to one rate by their times."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.blocks import Blocking, sound_blocks
from torquerig.recordings.files.rate_changes import stretches_of_rates
from torquerig.recordings.files.timing import timing_of
from torquerig.recordings.inspection.recording_info import stream_info
from torquerig.recordings.joining.join import join_recordings


def times_of(*parts: tuple[int, float]) -> np.ndarray:
    """Return the times of consecutive stretches of (samples, rate)."""
    steps = np.concatenate([np.full(samples, 1 / rate) for samples, rate in parts])
    return np.round(np.concatenate([[0], np.cumsum(steps)[:-1]]), 9)


def written(path: Path, times: np.ndarray) -> Path:
    rows = [f"{time:.9f},{2 + np.sin(2 * np.pi * 120 * time):.6f}" for time in times]
    path.write_text("Time [s],Torque [Nm]\n" + "\n".join(rows) + "\n")
    return path


PARTS = {
    "half the rate": ((1500, 2000), (1500, 1000)),
    "a quarter more": ((700, 2000), (900, 2500)),
    "three rates": ((400, 1000), (410, 4000), (400, 1000)),
    "two per cent": ((2000, 1000), (2000, 1020)),
}


@pytest.mark.parametrize("parts", PARTS.values(), ids=PARTS)
def test_the_rates_are_named_and_joined(tmp_path: Path, parts: tuple[tuple[int, float], ...]) -> None:
    times = times_of(*parts)
    path = written(tmp_path / "run1.csv", times)
    found = stretches_of_rates(times)
    assert [one.rate for one in found] == pytest.approx([rate for _, rate in parts], rel=1e-4)
    edges = np.cumsum([samples for samples, _ in parts])[:-1]
    assert [one.first for one in found[1:]] == pytest.approx(edges, abs=1)
    with pytest.raises(RecordingError, match=r"changes its rate"):
        read_recording(path)
    stream = open_stream(path)
    with pytest.raises(RecordingError, match=r"changes its rate|jumps by"):
        list(sound_blocks(stream, Blocking(samples=2**16)))
    assert "changes its rate" in stream_info(stream).suspicions()[0]
    joined = join_recordings([path])
    assert joined.recording.sample_rate == pytest.approx(max(rate for _, rate in parts), rel=1e-4)
    assert "several rates" in joined.notes[0]
    grid = np.arange(joined.recording.samples) / joined.recording.sample_rate
    off = np.abs(joined.recording.channels["Torque"].values - 2 - np.sin(2 * np.pi * 120 * grid))
    bounds = [0, *(times[edge] for edge in edges), times[-1]]
    inner = np.zeros(grid.size, dtype=bool)
    for low, high in pairwise(bounds):
        inner |= (grid > low + 0.04) & (grid < high - 0.04)  # the interpolating filter reaches 32 samples
    assert np.max(off[inner]) < 0.02


@pytest.mark.parametrize("lost", [1, 3, 20])
def test_lost_samples_are_no_change_of_rate(lost: int) -> None:
    places = np.random.default_rng(lost).choice(np.arange(50, 2950), lost, replace=False)
    times = np.delete(times_of((3000, 2000)), places)
    assert stretches_of_rates(times) == ()
    assert "lost" in timing_of(times, name="time").problem


def test_uneven_times_without_a_jump_are_told(tmp_path: Path) -> None:
    times = np.cumsum(np.random.default_rng(1).uniform(0.8e-3, 1.2e-3, 900)) ** 1.01
    path = written(tmp_path / "run1.csv", times)
    assert "not evenly spaced" in stream_info(open_stream(path)).suspicions()[0]


@pytest.mark.parametrize("size", [0, 1])
def test_too_few_times_are_a_problem(size: int) -> None:
    assert "2 are needed" in timing_of(np.zeros(size), name="time").problem


def test_a_table_of_one_row_is_refused(tmp_path: Path) -> None:
    path = written(tmp_path / "run1.csv", np.zeros(1))
    for read in (read_recording, lambda one: join_recordings([one])):
        with pytest.raises(RecordingError, match="2 are needed"):
            read(path)
