"""TDMS files as LabVIEW and DAQmx write them: raw data with scales, groups of several rates, other channels."""

import importlib
import struct
from pathlib import Path

import numpy as np
import pytest
from nptdms import ChannelObject, RootObject, TdmsFile, TdmsWriter

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording, tdms_pieces
from torquerig.recordings.files.tdms import read_tdms
from torquerig.recordings.joining.join import join_recordings

META, NEW, RAW, DAQMX = 2, 4, 8, 128


def text(value: str) -> bytes:
    return struct.pack("<I", len(value.encode())) + value.encode()


def properties(values: dict[str, object]) -> bytes:
    data = struct.pack("<I", len(values))
    for name, value in values.items():
        data += text(name)
        if isinstance(value, str):
            data += struct.pack("<I", 0x20) + text(value)
        elif isinstance(value, float):
            data += struct.pack("<Id", 10, value)
        else:
            data += struct.pack("<II", 7, value)
    return data


def daqmx_file(path: Path, counts: np.ndarray, scales: list[dict[str, object]]) -> None:
    """Write int16 counts, shape (samples, channels), interleaved as DAQmx streams them to disk."""
    samples, channels = counts.shape
    objects = b""
    for index in range(channels):
        scaler = struct.pack("<IIIII", 3, 0, 2 * index, 0, 0)
        index_data = struct.pack("<IIIQI", 0x1269, 0xFFFFFFFF, 1, samples, 1) + scaler
        index_data += struct.pack("<II", 1, 2 * channels)
        values = {"wf_increment": 1e-3, "unit_string": "Nm", "NI_Number_Of_Scales": 2, **scales[index]}
        objects += text(f"/'Data'/'Dev1/ai{index}'") + index_data + properties(values)
    meta = struct.pack("<I", channels) + objects
    raw = np.ascontiguousarray(counts, dtype="<i2").tobytes()
    lead = struct.pack("<4sIIQQ", b"TDSm", META | NEW | RAW | DAQMX, 4713, len(meta) + len(raw), len(meta))
    path.write_bytes(lead + meta + raw)


def linear(slope: float, offset: float) -> dict[str, object]:
    return {"NI_Scale[1]_Scale_Type": "Linear", "NI_Scale[1]_Linear_Slope": slope,
            "NI_Scale[1]_Linear_Y_Intercept": offset, "NI_Scale[1]_Linear_Input_Source": 0}  # fmt: skip


def polynomial(*coefficients: float) -> dict[str, object]:
    values = {f"NI_Scale[1]_Polynomial_Coefficients[{index}]": value for index, value in enumerate(coefficients)}
    return {"NI_Scale[1]_Scale_Type": "Polynomial", "NI_Scale[1]_Polynomial_Coefficients_Size": len(coefficients),
            "NI_Scale[1]_Polynomial_Input_Source": 0, **values}  # fmt: skip


@pytest.mark.parametrize("largest", [10, 10**6])
def test_raw_daqmx_data_with_scales(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, largest: int) -> None:
    monkeypatch.setattr(tdms_pieces, "_LARGEST_CHUNK", largest)
    counts = np.stack([np.arange(-40, 60), np.arange(100)], axis=1)
    daqmx_file(tmp_path / "run.tdms", counts, [linear(0.5, 1.0), polynomial(1.0, 2.0, 0.25)])
    table = read_tdms(tmp_path / "run.tdms")
    assert np.allclose(table.columns["Dev1/ai0"], 1 + 0.5 * counts[:, 0], rtol=1e-14)
    assert np.allclose(table.columns["Dev1/ai1"], 1 + 2 * counts[:, 1] + 0.25 * counts[:, 1] ** 2.0, rtol=1e-14)
    assert table.units == {"Dev1/ai0": "Nm", "Dev1/ai1": "Nm"}
    stream = open_stream(tmp_path / "run.tdms")
    assert ("raw DAQmx data" in stream.table.read_whole) is (largest == 10)
    for name, values in table.columns.items():
        assert np.array_equal(np.concatenate([piece[name] for piece in stream.columns()]), values)


def written(path: Path, *channels: tuple[str, str, object, dict[str, object]]) -> Path:
    with TdmsWriter(path) as writer:
        writer.write_segment([RootObject({"Operator": "me"}), *(ChannelObject(*one) for one in channels)])
    return path


@pytest.mark.parametrize("rates", [(1000.0, 100.0), (51200.0, 1000.0), (1000.0, 1000.0)])
def test_groups_of_several_rates(tmp_path: Path, rates: tuple[float, float]) -> None:
    parts = [
        (group, "Value", np.arange(200.0), {"wf_increment": 1 / rate, "unit_string": unit})
        for group, rate, unit in zip(("fast", "slow"), rates, ("Nm", "rpm"), strict=True)
    ]
    path = written(tmp_path / "run.tdms", *parts)
    table = read_tdms(path)
    assert table.rates == {"fast/Value": rates[0], "slow/Value": rates[1]}
    assert table.units == {"fast/Value": "Nm", "slow/Value": "rpm"}
    if rates[0] == rates[1]:
        assert read_recording(path).sample_rate == rates[0]
        return
    for read in (read_recording, open_stream):
        with pytest.raises(
            RecordingError, match=rf"fast/Value has {rates[0]:.10g} .* and slow/Value has {rates[1]:.10g}; .*join"
        ):
            read(path)


def test_other_channels_are_skipped_by_name(tmp_path: Path) -> None:
    moments = np.array(["2024-05-01T10:00:00", "2024-05-01T10:00:01"], dtype="datetime64[us]")
    path = written(
        tmp_path / "run.tdms",
        ("a", "torque_Nm", np.arange(9.0), {"wf_increment": 1e-3}),
        ("a", "remark", ["idle", "load"], {}),
        ("a", "moment", moments, {}),
        ("a", "spare", np.empty(0), {"wf_increment": 1e-3}),
        ("a", "spectrum", np.arange(9.0), {"wf_increment": 0.5, "wf_xname": "Frequency", "wf_xunit_string": "Hz"}),
        ("a", "z", np.arange(9) * 1j, {}),
    )
    assert read_tdms(path).skipped == {
        "remark": "texts", "moment": "time stamps", "spare": "it has no samples",
        "spectrum": "its X unit is Hz, not one of time", "z": "complex numbers",
    }  # fmt: skip
    recording = read_recording(path)
    assert (list(recording.channels), recording.sample_rate) == (["torque_Nm"], 1000)
    assert open_stream(path).table.skipped == read_tdms(path).skipped


@pytest.mark.parametrize(("unit", "rate"), [("s", 1000.0), ("ms", 1e6), ("", 1000.0)])
def test_the_unit_of_the_increment(tmp_path: Path, unit: str, rate: float) -> None:
    path = written(tmp_path / "run.tdms", ("a", "t", np.arange(9.0), {"wf_increment": 1e-3, "wf_xunit_string": unit}))
    assert read_tdms(path).rates["t"] == pytest.approx(rate)


def test_a_channel_that_starts_later_is_noted(tmp_path: Path) -> None:
    path = written(
        tmp_path / "run.tdms",
        ("a", "torque_Nm", np.arange(9.0), {"wf_increment": 1e-3}),
        ("a", "speed_rpm", np.arange(9.0), {"wf_increment": 1e-3, "wf_start_offset": 0.5}),
    )
    assert "speed_rpm starts 0.5 s after torque_Nm" in read_tdms(path).notes[0]


@pytest.mark.parametrize("more", [0, 3])
@pytest.mark.parametrize(
    "start", [{"wf_start_offset": 0.5}, {"wf_start_time": np.datetime64("2026-01-01T00:00:00.500000")}]
)
def test_a_later_start_names_join_as_the_remedy(tmp_path: Path, start: dict[str, object], more: int) -> None:
    first = {"wf_increment": 1e-3, "wf_start_offset": 0.0}
    if "wf_start_time" in start:
        first["wf_start_time"] = np.datetime64("2026-01-01T00:00:00.000000")
    path = written(
        tmp_path / "run.tdms",
        ("a", "torque_Nm", np.arange(900.0), first),
        ("a", "speed_rpm", np.arange(900.0 + more), {"wf_increment": 1e-3, **start}),
    )
    for opened in (read_recording, open_stream):
        with pytest.raises(RecordingError, match=r"speed_rpm starts 0.5 s after torque_Nm; .* torquerig join"):
            opened(path)
    joined = join_recordings([path]).recording
    assert joined.samples == 400
    assert joined.channels["torque_Nm"].values[0] == pytest.approx(500)


def test_unequal_lengths_are_cut_by_join(tmp_path: Path) -> None:
    path = written(
        tmp_path / "run.tdms",
        ("a", "torque_Nm", np.arange(900.0), {"wf_increment": 1e-3}),
        ("a", "speed_rpm", np.arange(903.0), {"wf_increment": 1e-3}),
    )
    with pytest.raises(RecordingError, match=r"cut them to the time that all have with: torquerig join"):
        read_recording(path)
    assert join_recordings([path]).recording.samples == 900


@pytest.mark.parametrize("names", [("Dev1/ai0", "Drehmoment", "Speed "), ("Voltage_0", "acc", "p"), ("a", "b", "c")])
def test_channels_of_foreign_names_are_all_read(tmp_path: Path, names: tuple[str, ...]) -> None:
    units = ("V", "m/s^2", "bar")
    parts = [("g", name, np.arange(9.0), {"wf_increment": 1e-3, "unit_string": unit})
             for name, unit in zip(names, units, strict=True)]  # fmt: skip
    table = read_tdms(written(tmp_path / "run.tdms", *parts))
    assert table.units == dict(zip(names, units, strict=True))
    assert table.rates == dict.fromkeys(names, 1000.0)


def test_the_private_members_of_nptdms_are_there(tmp_path: Path) -> None:
    path = written(tmp_path / "run.tdms", ("a", "torque_Nm", np.arange(9.0), {}))
    with TdmsFile.open(path) as file:
        channel, segment = file["a"]["torque_Nm"], file._reader._segments[0]
        things = {
            "nptdms.tdms.TdmsFile": file, "nptdms.tdms.TdmsChannel": channel, "nptdms.reader.TdmsReader": file._reader,
            "nptdms.tdms_segment.TdmsSegment": segment,
            "nptdms.base_segment.BaseSegmentObject": segment.get_segment_object(channel.path),
        }  # fmt: skip
        for place, members in tdms_pieces.PRIVATE.items():
            module, _, name = place.rpartition(".")
            kind = getattr(importlib.import_module(module), name)
            assert isinstance(things.get(place, kind), kind) or things.get(place, kind) is kind
            assert [member for member in members if not hasattr(things.get(place, kind), member)] == []


def test_the_unit_that_daqmx_logs(tmp_path: Path) -> None:
    path = written(
        tmp_path / "run.tdms",
        ("a", "Torque", np.arange(9.0), {"wf_increment": 1e-3, "NI_UnitDescription": "Nm"}),
        ("a", "Speed", np.arange(9.0), {"wf_increment": 1e-3, "unit_string": "rpm", "NI_UnitDescription": "Volts"}),
    )
    assert read_tdms(path).units == {"Torque": "Nm", "Speed": "rpm"}


@pytest.mark.parametrize("name", ["Time", "ts", "Zeit"])
@pytest.mark.parametrize("largest", [tdms_pieces.PIECE, 10])
def test_time_stamps_are_the_times(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, largest: int) -> None:
    monkeypatch.setattr(tdms_pieces, "_LARGEST_CHUNK", largest)
    stamps = np.datetime64("2026-01-01T00:00:00") + (np.arange(500) * 1000).astype("timedelta64[us]")
    path = written(tmp_path / "run.tdms", ("g", name, stamps, {}), ("g", "torque_Nm", np.arange(500.0), {}))
    recording, stream = read_recording(path), open_stream(path)
    assert (list(recording.channels), recording.sample_rate, stream.sample_rate) == (["torque_Nm"], 1000, 1000)
    pieces = [one["torque_Nm"] for one in stream.table.pieces(["torque_Nm"])]
    assert np.array_equal(np.concatenate(pieces), np.arange(500.0))


def test_a_stated_increment_goes_before_time_stamps(tmp_path: Path) -> None:
    stamps = np.datetime64("2026-01-01T00:00:00") + np.arange(9).astype("timedelta64[s]")
    path = written(tmp_path / "run.tdms", ("g", "Time", stamps, {}), ("g", "a", np.arange(9.0), {"wf_increment": 1e-3}))
    assert read_tdms(path).skipped == {"Time": "time stamps"}
