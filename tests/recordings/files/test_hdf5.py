"""HDF5 files as Python, Julia and loggers write them: attributes for units and rates, groups, compound datasets."""

from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.hdf5 import hdf5_pieces, read_hdf5
from torquerig.recordings.files.number_table import Table

TIME = np.arange(500) / 1000
TORQUE = np.sin(TIME * 90)


def both_ways(path: Path) -> Any:
    table, pieces = read_hdf5(path), hdf5_pieces(path)
    assert (pieces.names, pieces.rates, pieces.skipped) == (tuple(table.columns), table.rates, table.skipped)
    parts = list(pieces.pieces(pieces.names))
    for name, values in table.columns.items():
        assert np.array_equal(np.concatenate([part[name] for part in parts]), values)
    return table


@pytest.mark.parametrize("ending", [".h5", ".hdf5"])
@pytest.mark.parametrize(
    ("key", "value"), [("sample_rate", 1000.0), ("fs", np.int32(1000)), ("dt", 0.001), ("delta", [0.001])]
)
@pytest.mark.parametrize("place", ["dataset", "group", "file"])
def test_units_and_rates_from_attributes(tmp_path: Path, ending: str, key: str, value: Any, place: str) -> None:
    path = tmp_path / f"run{ending}"
    with h5py.File(path, "w") as file:
        dataset = file.create_dataset("rig/Drehmoment", data=TORQUE.astype("f4"), compression="gzip")
        dataset.attrs["unit"] = np.bytes_("Nm") if ending == ".h5" else "Nm"
        {"dataset": dataset, "group": file["rig"], "file": file}[place].attrs[key] = value
    table = both_ways(path)
    assert (table.units, table.rates) == ({"Drehmoment": "Nm"}, {"Drehmoment": 1000})
    recording = read_recording(path)
    assert (recording.sample_rate, open_stream(path).sample_rate) == (1000, 1000)
    assert recording.channels["Drehmoment"].unit == "Nm"


def test_groups_of_several_rates(tmp_path: Path) -> None:
    path = tmp_path / "run.h5"
    with h5py.File(path, "w") as file:
        for name, step in (("fast", 1), ("slow", 10)):
            file[f"{name}/time"], file[f"{name}/value"] = TIME[::step], TORQUE[::step]
    table = both_ways(path)
    assert table.rates == {"fast.value": 1000, "slow.value": 100}
    with pytest.raises(RecordingError, match=r"fast.value has 1000 .* slow.value has 100; "):
        read_recording(path)


@pytest.mark.parametrize("names", [("torque", "speed"), (), ("a", "b", "c")])
@pytest.mark.parametrize("turned", [True, False])
def test_columns_of_a_matrix(tmp_path: Path, names: tuple[str, ...], turned: bool) -> None:
    matrix = np.column_stack([TORQUE, TIME])
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["data"] = matrix.T if turned else matrix
        if names:
            file["data"].attrs["columns"] = list(names)
        file["time_s"] = TIME
    columns = list(names) if len(names) == 2 else ["data_1", "data_2"]
    table = both_ways(tmp_path / "run.h5")
    assert sorted(table.columns) == sorted([*columns, "time_s"])
    assert np.array_equal(table.columns[columns[0]], TORQUE)


def test_compound_logical_and_other_datasets(tmp_path: Path) -> None:
    rows = np.zeros(500, dtype=[("time_s", "f8"), ("torque_Nm", "f4"), ("state", "S4")])
    rows["time_s"], rows["torque_Nm"] = TIME, TORQUE
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["log"], file["on"], file["words"] = rows, TIME > 0.1, np.array([b"a", b"b"])
        file["kp"], file["empty"] = 3.0, np.empty(0)
        file["circle"] = h5py.SoftLink("/")
    table = both_ways(tmp_path / "run.h5")
    assert sorted(table.columns) == ["on", "time_s", "torque_Nm"]
    assert table.skipped == {"log.state": "texts", "words": "texts", "kp": "a single number", "empty": "empty"}
    assert "on: true and false are read as 1 and 0" in table.notes


def test_a_rate_and_a_step_that_contradict(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["torque_Nm"] = TORQUE
        file["torque_Nm"].attrs["fs"], file["torque_Nm"].attrs["dt"] = 1000.0, 0.01
    with pytest.raises(RecordingError, match=r"dt states a rate of 100 Hz and fs one of 1000 Hz"):
        read_recording(tmp_path / "run.h5")


def test_no_vector_and_no_hdf5(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["kp"] = 3.0
    with pytest.raises(RecordingError, match=r"kp: a single number\); save each channel as a 1-D dataset"):
        read_recording(tmp_path / "run.h5")
    (tmp_path / "run.h5").write_bytes(b"no hdf5")
    with pytest.raises(RecordingError, match="not a whole HDF5 file"):
        read_recording(tmp_path / "run.h5")


@pytest.mark.parametrize(
    "stated",
    [
        {"dt": 0.5, "dt_unit": "ms"},
        {"dt_ms": 0.5},
        {"dt": "0.5 ms"},
        {"sampling_rate": 2.0, "sampling_rate_unit": "kHz"},
        {"sampling_rate": "2 kHz"},
        {"sample_rate": "2000"},
        {"fs_kHz": 2},
        {"fs": 2.0, "fs_units": np.bytes_("kS/s")},
    ],
)
def test_rates_and_steps_in_their_units(tmp_path: Path, stated: dict[str, Any]) -> None:
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["torque_Nm"] = TORQUE
        file["torque_Nm"].attrs.update(stated)
    assert both_ways(tmp_path / "run.h5").rates == {"torque_Nm": pytest.approx(2000)}


def test_a_rate_in_an_unknown_unit_is_refused(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["torque_Nm"] = TORQUE
        file["torque_Nm"].attrs.update({"sampling_rate": 2.0, "sampling_rate_unit": "furlong"})
    with pytest.raises(RecordingError, match=r"sampling_rate: 'furlong' is no unit of a rate; write Hz or kHz"):
        read_recording(tmp_path / "run.h5")


@pytest.mark.parametrize(("factor", "offset"), [(0.001, 0.0), (0.001, 1.5), (None, 1.5), (0.001, None)])
def test_packed_numbers_are_unpacked(tmp_path: Path, factor: float | None, offset: float | None) -> None:
    counts = np.arange(2000, 2100, dtype="i2")
    packing = {key: one for key, one in (("scale_factor", factor), ("add_offset", offset)) if one is not None}
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["torque"] = np.append(counts, np.int16(-32768))
        file["torque"].attrs.update({"units": "Nm", "fs": 1000.0, "_FillValue": np.int16(-32768), **packing})
    table = both_ways_with_gaps(tmp_path / "run.h5")
    assert table.columns["torque"][:-1] == pytest.approx(counts * (factor or 1.0) + (offset or 0.0))
    assert np.isnan(table.columns["torque"][-1])
    assert "torque: its numbers are scaled" in table.notes[0]


def test_other_scales_are_named_and_not_applied(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["torque_V"] = TORQUE
        file["torque_V"].attrs.update({"gain": 0.01, "fs": 1000.0})
        file["speed_rpm"] = TORQUE
        file["speed_rpm"].attrs.update({"gain": 1.0, "offset": 0, "fs": 1000.0})
    assert both_ways(tmp_path / "run.h5").notes == (
        "torque_V: its attribute gain = 0.01 is not applied; save scaled values",
    )


def both_ways_with_gaps(path: Path) -> Table:
    table, pieces = read_hdf5(path), hdf5_pieces(path)
    for name, values in table.columns.items():
        assert np.array_equal(np.concatenate([one[name] for one in pieces.pieces([name])]), values, equal_nan=True)
    return table
