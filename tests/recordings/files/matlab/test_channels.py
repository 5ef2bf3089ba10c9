"""Which channels a MATLAB file has: names, units, times and rates of structs, in every version of the format."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.recordings.files.matlab.matlab_files import function_handle, matlab_object, write
from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.mat import mat_pieces, read_mat
from torquerig.recordings.files.matlab.channels import short_names

TIME = np.arange(2000) / 1000
TORQUE = 2 + 0.3 * np.sin(105 * TIME)
SPEED = 1000 + 5 * np.sin(6 * TIME)

versions = pytest.mark.parametrize("version", ["6", "7", "7.3"])


def both_ways(path: Path) -> tuple[dict[str, np.ndarray], Any]:
    """Return the columns, which must be the same in pieces, and the table."""
    table, pieces = read_mat(path), mat_pieces(path)
    assert (pieces.names, pieces.rates, pieces.units) == (tuple(table.columns), table.rates, table.units)
    parts = list(pieces.pieces(pieces.names))
    for name, values in table.columns.items():
        assert np.array_equal(np.concatenate([part[name] for part in parts])[: values.size], values)
    return dict(table.columns), table


def ordered(names: Any, version: str) -> list[str]:
    """Return the names in the file's order; HDF5 sorts them."""
    return sorted(names) if version == "7.3" else list(names)


@versions
@pytest.mark.parametrize("order", [("torque", "speed"), ("speed", "torque")])
@pytest.mark.parametrize("fields", [("time", "data"), ("t", "values"), ("time_s", "y")])
def test_two_structs_with_equal_fields(
    tmp_path: Path, version: str, order: tuple[str, str], fields: tuple[str, str]
) -> None:
    samples = {"torque": TORQUE, "speed": SPEED}
    content = {name: {fields[0]: TIME, fields[1]: samples[name]} for name in order}
    path = write(tmp_path / "run.mat", content, version)
    columns, table = both_ways(path)
    assert ordered(columns, version) == ordered(
        [fields[0], f"{order[0]}.{fields[1]}", f"{order[1]}.{fields[1]}"], version
    )
    assert columns[f"torque.{fields[1]}"].mean() == pytest.approx(2.0, abs=0.01)
    assert columns[f"speed.{fields[1]}"].mean() == pytest.approx(1000, abs=0.1)
    assert "read once" in table.notes[0]
    (tmp_path / "run.yaml").write_text(f"channels:\n  {fields[1]}: {{quantity: torque, unit: Nm}}\n")
    with pytest.raises(RecordingError, match="there is no column"):
        read_recording(path)
    (tmp_path / "run.yaml").write_text(f"channels:\n  torque.{fields[1]}: {{quantity: torque, unit: Nm}}\n")
    assert read_recording(path).sample_rate == 1000
    assert open_stream(path).sample_rate == 1000


@versions
def test_structs_with_times_of_their_own(tmp_path: Path, version: str) -> None:
    slow = TIME[::10]
    content = {"torque": {"time": TIME, "data": TORQUE}, "speed": {"time": slow, "data": SPEED[::10]}}
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert ordered(columns, version) == ordered(["torque.data", "speed.data"], version)
    assert table.rates == {"torque.data": 1000, "speed.data": 100}
    content = {"torque": {"time": TIME, "data": TORQUE}, "speed": {"time": TIME + 0.5, "data": SPEED}}
    _, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert "starts 0.5 s before" in table.notes[0] or "starts 0.5 s after" in table.notes[0]
    content["speed"] = {"time": slow, "data": SPEED[::10]}
    content["speed"]["time"] = np.sort(np.random.default_rng(1).random(200))
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert ordered(columns, version) == ordered(["torque.data"], version)
    assert "speed.time are not even" in table.skipped["speed.data"]


@versions
def test_a_single_struct_keeps_its_short_names(tmp_path: Path, version: str) -> None:
    content = {"rig": {"name": "bench 2", "time": TIME, "torque_V": TORQUE, "Iq": SPEED}, "kp": 3.0}
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert ordered(columns, version) == ordered(["time", "torque_V", "Iq"], version)
    assert table.skipped == {"kp": "a single number"}


@versions
@pytest.mark.parametrize("label", ["torque", "<Torque>", ""])
def test_simulink_structure_with_time(tmp_path: Path, version: str, label: str) -> None:
    signals = {"values": np.column_stack([TORQUE, SPEED]), "label": label, "dimensions": 2.0}
    content = {"simout": {"time": TIME, "signals": signals, "blockName": "rig/To Workspace"}}
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    stem = label or "values"
    assert ordered(columns, version) == ordered(["time", f"{stem}_1", f"{stem}_2"], version)
    assert np.array_equal(columns[f"{stem}_2"], SPEED)
    assert f"read as {stem}_1 to {stem}_2" in table.notes[0]


@versions
def test_scope_data_of_several_axes(tmp_path: Path, version: str) -> None:
    signals = [{"values": TORQUE, "label": "torque_Nm"}, {"values": SPEED, "label": "speed_rpm"}]
    content = {"ScopeData": {"time": TIME, "signals": signals}}
    path = write(tmp_path / "run.mat", content, version)
    columns, _ = both_ways(path)
    assert ordered(columns, version) == ordered(["time", "torque_Nm", "speed_rpm"], version)
    assert read_recording(path).channels["speed_rpm"].unit == "rpm"
    unlabelled = [{"values": one["values"], "label": ""} for one in signals]
    columns, _ = both_ways(write(path, {"ScopeData": {"time": TIME, "signals": unlabelled}}, version))
    assert ordered(columns, version) == ordered(["time", "signals_1.values", "signals_2.values"], version)


@versions
@pytest.mark.parametrize("axis", ["Time", "xAxis"])
def test_dspace_recording(tmp_path: Path, version: str, axis: str) -> None:
    y = [{"Name": "Torque", "Data": TORQUE, "Unit": "N*m"}, {"Name": "Model Root/Speed", "Data": SPEED, "Unit": "rpm"}]
    content = {"run1": {"X": {"Name": axis, "Data": TIME, "Unit": "s"}, "Y": y, "Description": "x"}}
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    time = "Time" if axis == "Time" else "time_s"
    assert ordered(columns, version) == ordered([time, "Torque", "Model Root/Speed"], version)
    assert table.units == {time: "s", "Torque": "N*m", "Model Root/Speed": "rpm"}
    assert np.array_equal(columns["Torque"], TORQUE)


@versions
def test_units_and_rates_of_each_struct(tmp_path: Path, version: str) -> None:
    content = {"torque": {"data": TORQUE, "unit": "Nm", "fs": 1000.0}, "acc": {"data": SPEED, "unit": "g", "fs": 500.0}}
    _, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert table.units == {"torque.data": "Nm", "acc.data": "g"}
    assert table.rates == {"torque.data": 1000, "acc.data": 500}


@versions
def test_matrices_logical_and_complex(tmp_path: Path, version: str) -> None:
    content = {
        "time_s": TIME, "acc": np.column_stack([TORQUE, SPEED, TIME]), "gain": np.eye(3), "on": TIME > 1,
        "z": TORQUE + 1j * SPEED, "note": "hello", "cube": np.zeros((2000, 2, 2)),
    }  # fmt: skip
    columns, table = both_ways(write(tmp_path / "run.mat", content, version))
    assert ordered(columns, version) == ordered(["time_s", "acc_1", "acc_2", "acc_3", "on"], version)
    assert np.array_equal(columns["acc_2"], SPEED)
    assert columns["on"].tolist() == [float(time > 1) for time in TIME]
    assert table.skipped["gain"] == "a matrix of 3 x 3, and no channel is as long"
    assert table.skipped["z"].startswith("complex numbers")
    assert (table.skipped["note"], table.skipped["cube"]) == ("a text", "an array of 3 dimensions")
    assert "on: true and false are read as 1 and 0" in table.notes


@pytest.mark.parametrize("packed", [True, False])
@pytest.mark.parametrize("names", [("remark",), ("operator", "remark"), ("tt", "s", "f")])
def test_objects_are_skipped_by_name(tmp_path: Path, names: tuple[str, ...], packed: bool) -> None:
    path = write(tmp_path / "run.mat", {"time_s": TIME, "torque_Nm": TORQUE}, "7" if packed else "6")
    kinds = dict(zip(names, ("string", "datetime", "calendarDuration"), strict=False))
    path.write_bytes(path.read_bytes() + b"".join(matlab_object(*one) for one in kinds.items()) + function_handle("g"))
    recording = read_recording(path)
    assert (recording.sample_rate, recording.samples) == (1000, 2000)
    expected = {name: f"a MATLAB object of the class {kind}" for name, kind in kinds.items()}
    assert read_mat(path).skipped == {**expected, "g": "a function handle"}


@pytest.mark.parametrize(
    ("kind", "hint"), [("table", "table2struct"), ("timetable", "writetimetable"), ("timeseries", "x.Time and x.Data")]
)
def test_an_object_of_channels_names_the_export(tmp_path: Path, kind: str, hint: str) -> None:
    path = write(tmp_path / "run.mat", {"kp": 1.0}, "7")
    path.write_bytes(path.read_bytes() + matlab_object("run", kind))
    with pytest.raises(RecordingError, match=hint):
        read_recording(path)


def test_one_matrix_is_time_and_volts_only_where_its_first_column_rises(tmp_path: Path) -> None:
    path = write(tmp_path / "run.mat", {"data": np.column_stack([TIME, TORQUE])}, "7")
    assert list(read_mat(path).columns) == ["time_s", "torque_V"]
    path = write(tmp_path / "run.mat", {"data": np.column_stack([SPEED, TORQUE])}, "7")
    assert list(read_mat(path).columns) == ["data_1", "data_2"]


def test_the_shortest_names_that_differ() -> None:
    assert short_names([("a", "x"), ("b", "y")]) == ["x", "y"]
    assert short_names([("a", "x"), ("b", "x"), ("b", "y")]) == ["a.x", "b.x", "y"]
    assert short_names([("x",), ("b", "x")]) == ["x", "b.x"]
    assert short_names([("p", "a", "x"), ("q", "a", "x")]) == ["p.a.x", "q.a.x"]
