"""Several columns of times in one table: each column has the rate and the start of its own times."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import h5py
import numpy as np
import pytest
from scipy.io import savemat

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.csv import source_pieces
from torquerig.recordings.files.number_table import Table
from torquerig.recordings.files.several_times.own_times import pieces_with_own_times, with_own_times
from torquerig.recordings.files.text_tables.source import open_text
from torquerig.recordings.joining.join import join_recordings

T = np.arange(3000) / 2000
TORQUE, SPEED = 2 + np.sin(20 * T), 1000 + np.cos(5 * T)
SLOW = slice(None, None, 20)


def write(path: Path, columns: Mapping[str, np.ndarray]) -> Path:
    if path.suffix == ".mat":
        savemat(path, dict(columns))
    elif path.suffix == ".h5":
        with h5py.File(path, "w") as file:
            for name, values in columns.items():
                file[name] = values
    else:
        rows = max(values.size for values in columns.values())
        lines = [
            ";".join(f"{one[row]:.12g}" if row < one.size else "" for one in columns.values()) for row in range(rows)
        ]
        path.write_text("\n".join([";".join(columns), *lines]) + "\n")
    return path


PAIRS = [
    ("Data1_time_Torque", "Data1_Torque", "Data1_time_Speed", "Data1_Speed"),
    ("t_torque", "torque", "t_speed", "speed"),
    ("torque_time", "torque", "speed_time", "speed"),
    ("time_1", "torque_1", "time_2", "speed_2"),
]


@pytest.mark.parametrize("names", PAIRS)
@pytest.mark.parametrize("ending", [".mat", ".h5", ".csv"])
def test_times_belong_to_columns_by_name(tmp_path: Path, names: tuple[str, ...], ending: str) -> None:
    path = write(tmp_path / f"run{ending}", dict(zip(names, (T, TORQUE, T[SLOW], SPEED[SLOW]), strict=True)))
    with pytest.raises(RecordingError, match=f"{names[1]} has 2000 .*{names[3]} has 100|{names[3]} has 100 .*2000"):
        read_recording(path)
    with pytest.raises(RecordingError, match="torquerig join"):
        open_stream(path)
    joined = join_recordings([path]).recording
    assert joined.sample_rate == 2000
    assert set(joined.channels) == {names[1], names[3]}
    found, inner = joined.channels[names[3]].values, slice(200, 2500)
    assert found[inner] == pytest.approx(SPEED[: found.size][inner], abs=1e-2)


PLACES = [
    ("Time 1 [s]", "Torque [Nm]", "Time 2 [s]", "Speed [rpm]"),
    ("Time - Torque", "Amplitude - Torque", "Time - Speed", "Amplitude - Speed"),
    ("Time [s]", "Torque [Nm]", "Time [s]_2", "Speed [rpm]"),
    ("t1", "Torque [Nm]", "t2", "Speed [rpm]"),
]


@pytest.mark.parametrize("names", PLACES)
@pytest.mark.parametrize(("times", "expected"), [(10 * T, (2000, 200)), (T[SLOW], (2000, 100))])
def test_times_belong_to_the_columns_behind_them(
    names: tuple[str, ...], times: np.ndarray, expected: tuple[float, float]
) -> None:
    columns = dict(zip(names, (T, TORQUE, np.full_like(T, np.nan), np.full_like(T, np.nan)), strict=True))
    columns[names[2]][: times.size], columns[names[3]][: times.size] = times, SPEED[: times.size]
    table = with_own_times(Table(columns=columns))
    assert list(table.columns) == [names[1], names[3]]
    assert tuple(table.rates.values()) == pytest.approx(expected)
    assert [one.size for one in table.columns.values()] == [T.size, times.size]


def test_a_text_read_in_pieces_gives_the_same(tmp_path: Path) -> None:
    columns = {"Time 1 [s]": T, "Torque [Nm]": TORQUE, "Time 2 [s]": T[SLOW] + 0.25, "Speed [rpm]": SPEED[SLOW]}
    path = write(tmp_path / "run.csv", columns)
    pieces = pieces_with_own_times(source_pieces(open_text(path), step=2**12))
    assert pieces.rates == {"Torque [Nm]": 2000, "Speed [rpm]": 100}
    assert pieces.starts == {"Torque [Nm]": 0, "Speed [rpm]": 0.25}
    assert pieces.lengths == {"Torque [Nm]": 3000, "Speed [rpm]": 150}
    found = np.concatenate([one["Speed [rpm]"] for one in pieces.pieces(["Speed [rpm]"])])
    assert found == pytest.approx(SPEED[SLOW])


@pytest.mark.parametrize("second", [T, T + 1e-5, T + 1.7e9, np.floor(T) + 1.7e9])
def test_equal_times_are_read_once(second: np.ndarray) -> None:
    columns = {"time_s": T, "torque_Nm": TORQUE, "timestamp": second, "speed_rpm": SPEED}
    table = with_own_times(Table(columns=columns))
    assert list(table.columns) == ["time_s", "torque_Nm", "speed_rpm"]
    assert "the same samples; time_s is read" in table.notes[0]


def test_times_in_two_units_are_the_same() -> None:
    columns = {"Time [s]": T, "Torque [Nm]": TORQUE, "Time [ms]": 1000 * T, "Speed [rpm]": SPEED}
    assert list(with_own_times(Table(columns=columns)).columns) == ["Time [s]", "Torque [Nm]", "Speed [rpm]"]


def test_a_later_start_is_refused_and_joined(tmp_path: Path) -> None:
    path = write(tmp_path / "run.mat", {"t_torque": T, "torque": TORQUE, "t_speed": T + 0.5, "speed": SPEED})
    with pytest.raises(RecordingError, match=r"speed starts 0.5 s after torque; .*torquerig join"):
        read_recording(path)
    joined = join_recordings([path]).recording
    assert joined.channels["torque"].values[:100] == pytest.approx(TORQUE[1000:1100])


def test_times_of_unknown_columns_give_no_rate(tmp_path: Path) -> None:
    columns = {"Speed [rpm]": SPEED, "Time 1 [s]": T, "Time 2 [s]": 10 * T, "Torque [Nm]": TORQUE}
    table = with_own_times(Table(columns=columns))
    assert not table.rates
    assert table.time_name() is None
    assert "neither names nor places show whose they are" in table.notes[0]
    with pytest.raises(RecordingError, match="the sample rate is not stated"):
        read_recording(write(tmp_path / "run.csv", columns))


def test_uneven_times_lose_only_their_columns() -> None:
    times = np.delete(np.arange(3001) / 2000, 700)
    times[2000:] -= 0.4
    columns = {"t_torque": T, "torque": TORQUE, "t_speed": times, "speed": SPEED}
    table = with_own_times(Table(columns=columns))
    assert list(table.columns) == ["torque"]
    assert "its times t_speed" in table.skipped["speed"]


@pytest.mark.parametrize(
    ("name", "values"),
    [("t_motor", 20 + 1e-4 * T), ("delay time [s]", 0 * T + 0.1), ("Lap time [s]", T % 0.5), ("T_torque", 20 + T)],
)
def test_a_column_that_is_no_time_stays(name: str, values: np.ndarray) -> None:
    table = Table(columns={"time_s": T, "torque": TORQUE, name: values, "speed_rpm": SPEED})
    assert with_own_times(table) is table


def test_a_sidecar_names_a_channel_of_times() -> None:
    table = Table(columns={"time_s": T, "torque": TORQUE, "Time 2 [s]": 10 * T, "speed": SPEED})
    assert with_own_times(table, kept=["torque", "Time 2"]) is table


@pytest.mark.parametrize("seed", range(4))
def test_damaged_times_are_no_traceback(seed: int) -> None:
    random = np.random.default_rng(seed)
    bad = [np.nan, np.inf, -np.inf, 1e308, -1e308, 0.0]
    for names in [("t_a", "a", "t_b", "b"), ("time_s", "a", "Time 2", "b"), ("Time", "Zeit", "a", "b")] * 20:
        columns = {name: T[:200] * random.choice([1.0, 10.0, 1e300]) for name in names}
        for values in columns.values():
            values[random.integers(0, 200, random.integers(0, 4))] = random.choice(bad)
            values[random.choice([200, 200, 150, 1, 0]) :] = np.nan
        table = with_own_times(Table(columns=columns))
        assert set(table.columns) <= {*names, "time_s"}
    assert not with_own_times(Table(columns={"t_a": T[:0], "a": T[:0], "t_b": T[:1], "b": T[:1]})).rates
