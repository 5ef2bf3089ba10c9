"""Several channels in the rows of one column are refused, with the column that numbers them."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.joining.join import join_recordings


def written(path: Path, rows: list[tuple[float, object, float]], name: str = "Channel") -> Path:
    text = "".join(f"{time:.4f},{channel},{value:.3f}\n" for time, channel, value in rows)
    path.write_text(f"Time [s],{name},Torque [Nm]\n{text}")
    return path


@pytest.mark.parametrize(
    ("name", "channels"),
    [("Channel", [1, 2]), ("Kanal", ["T1", "T2"]), ("Sensor", [0, 1, 2]), ("Row", [1, 2, 3, 4])],
)
def test_channels_that_alternate(tmp_path: Path, name: str, channels: list[object]) -> None:
    rows = [(k / 2000, one, 2 + place) for k in range(100) for place, one in enumerate(channels)]
    path = written(tmp_path / "run1.csv", rows, name)
    for read in (read_recording, open_stream, lambda one: join_recordings([one])):
        with pytest.raises(
            RecordingError, match=f"each time of Time stands {len(channels)} times, and the column {name}"
        ):
            read(path)


def test_channels_that_follow_one_another(tmp_path: Path) -> None:
    rows = [(k / 2000, one, 2.0 + one) for one in (1, 2, 3) for k in range(100)]
    path = written(tmp_path / "run1.csv", rows)
    for read in (read_recording, open_stream, lambda one: join_recordings([one])):
        with pytest.raises(RecordingError, match="begins again where the column Channel changes: the samples of 3"):
            read(path)


def test_a_state_that_alternates_at_coarse_times_is_none(tmp_path: Path) -> None:
    rows = [(np.floor(k / 2) / 1000, k % 2, 2 + 0.1 * np.sin(k)) for k in range(400)]
    assert read_recording(written(tmp_path / "run1.csv", rows, "Relay")).sample_rate == 2000
