"""Dates and times of day as numbers give the true rate, or are refused with both readings."""

from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.joining.join import join_recordings

DAY = 86_400.0


def written(path: Path, times: list[str], name: str = "Time") -> Path:
    path.write_text(f"{name},Torque [Nm]\n" + "".join(f"{time},{2 + k % 7 / 10}\n" for k, time in enumerate(times)))
    return path


@pytest.mark.parametrize("digits", [3, 6])
@pytest.mark.parametrize("start", [datetime(2024, 3, 5, 10, 11, 59, 900_000), datetime(2024, 2, 29, 23, 59, 59)])
@pytest.mark.parametrize("sign", [".", ""])
def test_dates_written_as_one_number(tmp_path: Path, digits: int, start: datetime, sign: str) -> None:
    moments = [start + timedelta(milliseconds=2 * k) for k in range(1200)]
    times = [f"{one:%Y%m%d%H%M%S}{sign}{f'{one:%f}'[:digits]}" for one in moments]
    path = written(tmp_path / "run1.csv", times, "timestamp")
    assert read_recording(path).sample_rate == 500
    assert open_stream(path).sample_rate == 500


@pytest.mark.parametrize(("first", "program"), [(739316.4244, "MATLAB"), (45356.4244, "Excel")])
@pytest.mark.parametrize("rate", [50.0, 20.0, 500.0])
def test_day_numbers(tmp_path: Path, first: float, program: str, rate: float) -> None:
    times = first + np.arange(2000) / rate / DAY
    path = written(tmp_path / "run1.csv", [f"{one:.10f}" for one in times])
    assert read_recording(path).sample_rate == pytest.approx(rate, rel=1e-4)
    assert any(f"day number of {program}" in note for note in open_stream(path).table.notes)
    assert join_recordings([path]).recording.sample_rate == pytest.approx(rate, rel=1e-4)
    savemat(tmp_path / "run2.mat", {"Time": times, "Torque": np.sin(times)})
    assert open_stream(tmp_path / "run2.mat").sample_rate == pytest.approx(rate, rel=1e-4)


@pytest.mark.parametrize(("first", "rate"), [(0.0, 50.0), (0.4244, 50.0), (0.4244, 1.0), (0.0, 2000.0)])
def test_fractions_of_a_day_are_asked(tmp_path: Path, first: float, rate: float) -> None:
    path = written(tmp_path / "run1.csv", [f"{first + k / rate / DAY:.12f}" for k in range(300)])
    for read in (read_recording, open_stream, lambda one: join_recordings([one])):
        with pytest.raises(RecordingError, match=rf"Hz if they are seconds, and {rate:g} Hz if they are days"):
            read(path)
    path.with_suffix(".yaml").write_text(f"sample_rate_Hz: {rate:g}\n")
    assert read_recording(path).sample_rate == rate


@pytest.mark.parametrize("rate", [51_200.0, 96_000.0, 100_000.0, 1e6, 5e6])
def test_fast_seconds_stay_seconds(tmp_path: Path, rate: float) -> None:
    path = written(tmp_path / "run1.csv", [f"{k / rate:.12f}" for k in range(300)])
    assert read_recording(path).sample_rate == pytest.approx(rate, rel=1e-6)


def test_dates_that_a_number_cannot_hold_are_refused(tmp_path: Path) -> None:
    times = 20240305101159.0 + np.arange(300) * 0.0625
    savemat(tmp_path / "run1.mat", {"Time": times, "Torque": np.sin(times)})
    with pytest.raises(RecordingError, match=r"dates written as one number \(20240305101159\)"):
        open_stream(tmp_path / "run1.mat")


@pytest.mark.parametrize("name", ["time_d", "Time (days)", "Zeit in Tagen", "time_days"])
@pytest.mark.parametrize("rate", [0.37, 7.3, 1000.0])
def test_days_that_the_name_states(tmp_path: Path, name: str, rate: float) -> None:
    path = written(tmp_path / "run1.csv", [f"{k / rate / DAY:.14f}" for k in range(300)], name)
    assert read_recording(path).sample_rate == pytest.approx(rate, rel=1e-5)
    assert open_stream(path).sample_rate == pytest.approx(rate, rel=1e-5)
    assert join_recordings([path]).recording.sample_rate == pytest.approx(rate, rel=1e-5)
