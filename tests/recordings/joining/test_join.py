"""Columns of several rates and files of one run become one recording."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from nptdms import ChannelObject, TdmsWriter

from torquerig.cli import main
from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import read_recording
from torquerig.recordings.joining.join import join_recordings


def two_rates(path: Path, *, fast: float, slow: float, seconds: float = 4.0) -> None:
    with TdmsWriter(path) as file:
        for name, rate, unit in (("torque", fast, "Nm"), ("speed", slow, "rpm")):
            times = np.arange(round(seconds * rate)) / rate
            values = 2 + np.sin(2 * np.pi * 3 * times) if name == "torque" else 1000 + 5 * np.cos(2 * np.pi * times)
            properties = {"wf_increment": 1 / rate, "unit_string": unit}
            file.write_segment([ChannelObject("log", name, values, properties)])


@pytest.mark.long
@pytest.mark.parametrize(("fast", "slow"), [(1000, 100), (2500, 99.7), (51200, 50)])
def test_two_rates_of_one_file_become_the_higher(tmp_path: Path, fast: float, slow: float) -> None:
    path = tmp_path / "run.tdms"
    two_rates(path, fast=fast, slow=slow)
    with pytest.raises(RecordingError):
        read_recording(path)
    joined = join_recordings([path]).recording
    assert joined.sample_rate == fast
    inner = slice(int(0.5 * fast), int(3.3 * fast))
    times = joined.time()[inner]
    assert joined.channels["torque"].values[inner] == pytest.approx(2 + np.sin(2 * np.pi * 3 * times), abs=1e-12)
    assert joined.channels["speed"].values[inner] == pytest.approx(1000 + 5 * np.cos(2 * np.pi * times), abs=5e-3)


def test_a_slower_rate_has_no_aliases(tmp_path: Path) -> None:
    rate = 5000.0
    times = np.arange(20000) / rate
    values = 1.0 + 0.5 * np.sin(2 * np.pi * 20 * times) + 0.5 * np.sin(2 * np.pi * 930 * times)
    path = tmp_path / "run.csv"
    rows = zip(times, values, strict=True)
    path.write_text("time_s,torque_Nm\n" + "".join(f"{t:.6f},{v:.9f}\n" for t, v in rows))
    slow = join_recordings([path], rate=1000.0).recording
    middle = slice(500, 3500)
    expected = 1.0 + 0.5 * np.sin(2 * np.pi * 20 * slow.time())  # 930 Hz would appear at 70 Hz
    assert slow.torque()[middle] == pytest.approx(expected[middle], abs=1e-3)


def noise(samples: int, seed: int) -> np.ndarray:
    return np.convolve(np.random.default_rng(seed).standard_normal(samples + 30), np.ones(31) / 31, mode="valid")


def csv_of(path: Path, columns: dict[str, np.ndarray]) -> None:
    rows = zip(*columns.values(), strict=True)
    path.write_text(",".join(columns) + "\n" + "".join(",".join(f"{v:.9g}" for v in row) + "\n" for row in rows))


@pytest.mark.parametrize("delay", [0.0, 0.8125, -0.4])
def test_files_are_aligned_by_a_common_channel(tmp_path: Path, delay: float) -> None:
    whole = noise(12000, seed=3)
    first, second = 2000, 2000 + round(delay * 1000)
    csv_of(tmp_path / "a.csv", {"time_s": np.arange(6000) / 1000, "torque_Nm": whole[first : first + 6000]})
    part = whole[second : second + 6000]
    csv_of(tmp_path / "b.csv", {"time_s": np.arange(6000) / 1000, "torque_Nm": 3 * part, "force_N": part})
    joined = join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="torque_Nm")
    begins = float(joined.notes[0].split("begins ")[1].split(" s")[0])
    assert begins == pytest.approx(round(delay * 1000) / 1000, abs=1e-5)
    torque, force = joined.recording.channels["torque_Nm"].values, joined.recording.channels["force_N"].values
    assert np.abs(torque - force).max() < 5e-3 * torque.std()


def test_a_periodic_channel_aligns_nothing(tmp_path: Path) -> None:
    wave = np.sin(2 * np.pi * 5 * np.arange(4000) / 1000)
    for name in ("a.csv", "b.csv"):
        csv_of(tmp_path / name, {"time_s": np.arange(4000) / 1000, "torque_Nm": wave})
    with pytest.raises(RecordingError, match="repeats itself"):
        join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="torque_Nm")


def test_unrelated_channels_align_nothing(tmp_path: Path) -> None:
    for seed, name in enumerate(("a.csv", "b.csv")):
        csv_of(tmp_path / name, {"time_s": np.arange(4000) / 1000, "torque_Nm": noise(4000, seed=seed)})
    with pytest.raises(RecordingError, match="agree nowhere"):
        join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="torque_Nm")


def test_files_are_aligned_by_their_clocks(tmp_path: Path) -> None:
    whole = noise(9000, seed=5)
    csv_of(tmp_path / "a.csv", {"time_s": 10 + np.arange(5000) / 1000, "torque_Nm": whole[:5000]})
    csv_of(tmp_path / "b.csv", {"time_s": 12.5 + np.arange(5000) / 1000, "force_N": whole[2500:7500]})
    joined = join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="clock").recording
    assert joined.duration == pytest.approx(2.5, abs=2e-3)
    assert joined.channels["torque_Nm"].values == pytest.approx(joined.channels["force_N"].values, abs=1e-6)


def test_files_without_a_common_time_are_refused(tmp_path: Path) -> None:
    for start, name in ((0, "a.csv"), (60, "b.csv")):
        csv_of(tmp_path / name, {"time_s": start + np.arange(50) / 10, "torque_Nm": np.arange(50.0)})
    with pytest.raises(RecordingError, match="no common time"):
        join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="clock")


def test_an_unknown_channel_is_refused_with_the_close_ones(tmp_path: Path) -> None:
    for name in ("a.csv", "b.csv"):
        csv_of(tmp_path / name, {"time_s": np.arange(50) / 10, "torque_Nm": np.arange(50.0)})
    with pytest.raises(InputError, match="torque_Nm"):
        join_recordings([tmp_path / "a.csv", tmp_path / "b.csv"], align="torque")


def test_a_gap_is_bridged_and_told(tmp_path: Path) -> None:
    times = np.delete(np.arange(3000) / 1000, slice(1000, 1020))
    csv_of(tmp_path / "run.csv", {"time_s": times, "torque_Nm": 2 + times})
    joined = join_recordings([tmp_path / "run.csv"])
    assert joined.recording.samples == 3000
    assert joined.recording.torque() == pytest.approx(2 + joined.recording.time(), abs=1e-6)
    assert "1 steps of time_s are not one sample long" in joined.notes[0]


def test_a_wrapping_angle_is_held_and_not_smeared(tmp_path: Path) -> None:
    with TdmsWriter(tmp_path / "run.tdms") as file:
        angle = np.arange(400) * 3.6 % 360
        for name, values, dt, unit in (("torque", np.zeros(4000), 1e-3, "Nm"), ("angle", angle, 1e-2, "deg")):
            file.write_segment([ChannelObject("g", name, values, {"wf_increment": dt, "unit_string": unit})])
    joined = join_recordings([tmp_path / "run.tdms"]).recording
    assert set(np.round(joined.channels["angle"].values, 6)) <= set(np.round(angle, 6))


def test_the_command_writes_what_it_says(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    two_rates(tmp_path / "run.tdms", fast=1000, slow=100)
    main(("join", str(tmp_path / "run.tdms"), "--out", str(tmp_path / "one.parquet"), "--rate", "500 Hz"))
    shown = " ".join(capsys.readouterr().out.split())
    assert "torque: 1000 Hz to 500 Hz, low-passed" in shown
    assert "speed: 100 Hz to 500 Hz, interpolated" in shown
    assert read_recording(tmp_path / "one.parquet").sample_rate == 500


def test_channels_of_one_file_start_when_it_says(tmp_path: Path) -> None:
    whole = noise(3000, seed=8)
    with TdmsWriter(tmp_path / "run.tdms") as file:
        for name, first, unit in (("torque", 0, "Nm"), ("force", 500, "N")):
            properties = {"wf_increment": 1e-3, "wf_start_offset": first * 1e-3, "unit_string": unit}
            file.write_segment([ChannelObject("g", name, whole[first : first + 2000], properties)])
    joined = join_recordings([tmp_path / "run.tdms"]).recording
    assert joined.duration == pytest.approx(1.5, abs=2e-3)
    assert joined.channels["torque"].values == pytest.approx(joined.channels["force"].values, abs=1e-9)


@pytest.mark.parametrize("minutes", [0.0, 1.0])
def test_two_files_meet_on_the_clock_of_the_logger(tmp_path: Path, minutes: float) -> None:
    whole = noise(9000, seed=9)
    begin = np.datetime64("2024-05-01T10:00:00.000000")
    for name, channel, unit, first in (("a", "torque", "Nm", 0), ("b", "force", "N", 1000)):
        start = begin + np.timedelta64(round((first * 1e-3 + (minutes * 60 if name == "b" else 0)) * 1e6), "us")
        with TdmsWriter(tmp_path / f"{name}.tdms") as file:
            properties = {"wf_increment": 1e-3, "wf_start_time": start, "unit_string": unit}
            file.write_segment([ChannelObject("g", channel, whole[first : first + 4000], properties)])
    paths = [tmp_path / "a.tdms", tmp_path / "b.tdms"]
    if minutes:
        with pytest.raises(RecordingError, match="no common time"):
            join_recordings(paths, align="clock")
        return
    joined = join_recordings(paths, align="clock").recording
    assert joined.duration == pytest.approx(3.0, abs=2e-3)
    assert joined.channels["torque"].values == pytest.approx(joined.channels["force"].values, abs=1e-6)


def test_a_stated_rate_does_not_hide_lost_samples(tmp_path: Path) -> None:
    path = tmp_path / "run1.csv"
    numbers = [number for number in range(2000) if not 700 <= number < 720]
    path.write_text("Time [s],Torque [Nm]\n" + "".join(f"{k / 1000:.3f},{2 + k / 1000:.3f}\n" for k in numbers))
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 1000\n")
    joined = join_recordings([path])
    assert joined.recording.samples == 2000
    assert joined.recording.channels["Torque"].values == pytest.approx(2 + np.arange(2000) / 1000, abs=1e-9)
    assert "bridged" in joined.notes[0]
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 1500\n")
    path.write_text("Time [s],Torque [Nm]\n" + "".join(f"{k / 1000:.3f},2.{k % 7}\n" for k in range(2000)))
    with pytest.raises(RecordingError, match="states 1500 samples per second and the column Time states 1000"):
        join_recordings([path])
