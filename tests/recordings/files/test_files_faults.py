"""Every fault in every format: one sentence that names it, read at once or in blocks; or a warning with its samples."""

import struct
from collections.abc import Callable, Mapping
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pytest
from nptdms import ChannelObject, TdmsWriter
from pyarrow import parquet
from scipy.io import savemat, wavfile

from torquerig.cli import main
from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.blocks import Blocking, sound_blocks
from torquerig.recordings.inspection.recording_info import stream_info

RATE = 1000.0
Columns = Mapping[str, np.ndarray]


def _parquet(path: Path, columns: Columns) -> None:
    parquet.write_table(pa.table(dict(columns)), path)


def _csv(path: Path, columns: Columns) -> None:
    rows = [",".join(columns), *(",".join(f"{x!r}" for x in row) for row in _rows(columns))]
    path.write_text("\n".join(rows) + "\n")


def _text(path: Path, columns: Columns) -> None:
    times = [index / RATE for index in range(len(_rows(columns)))]
    lines = [f"{time:.3f}  {row[0]!r}" for time, row in zip(times, _rows(columns), strict=True)]
    path.write_text("time_s torque_V\n" + "\n".join(lines) + "\n")


def _mat(path: Path, columns: Columns) -> None:
    savemat(path, dict(columns), oned_as="column")


def _mat73(path: Path, columns: Columns) -> None:
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in columns.items():
            file[name] = values.reshape(1, -1)


def _tdms(path: Path, columns: Columns) -> None:
    with TdmsWriter(path) as writer:
        writer.write_segment([ChannelObject("a", name, values) for name, values in columns.items()])


def _lvm(path: Path, columns: Columns) -> None:
    head = "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\n\nX_Value\t" + "\t".join(columns) + "\n"
    rows = [
        "\t".join([f"{index / RATE:.3f}", *(f"{float(x)!r}" for x in row)]) for index, row in enumerate(_rows(columns))
    ]
    path.write_text(head + "\n".join(rows) + "\n")


def _wav(path: Path, columns: Columns) -> None:
    wavfile.write(path, int(RATE), np.stack(list(columns.values()), axis=1).astype(np.float32))


FORMATS: dict[str, tuple[str, Callable[[Path, Columns], None]]] = {
    "parquet": (".parquet", _parquet),
    "csv": (".csv", _csv),
    "text": (".txt", _text),
    "mat v5": (".mat", _mat),
    "mat v7.3": (".mat", _mat73),
    "tdms": (".tdms", _tdms),
    "lvm": (".lvm", _lvm),
    "wav": (".wav", _wav),
}


def _rows(columns: Columns) -> list[tuple[float, ...]]:
    return [tuple(float(x) for x in row) for row in zip(*columns.values(), strict=True)]


def made(
    folder: Path, form: str, columns: Columns, *, rate: float = RATE, names: tuple[str, ...] | None = None
) -> Path:
    """Write a recording and its sidecar."""
    ending, write = FORMATS[form]
    path = folder / f"run1{ending}"
    write(path, columns)
    listed = [f"channel_{index + 1}" for index in range(len(columns))] if form == "wav" else list(columns)
    entries = "".join(f"  {name}: {{quantity: torque, unit: V, Nm_per_V: 1.0}}\n" for name in (names or tuple(listed)))
    path.with_suffix(".yaml").write_text(f"sample_rate_Hz: {rate:g}\nchannels:\n{entries}")
    return path


def torque(samples: int = 400) -> np.ndarray:
    return np.round(np.random.default_rng(1).standard_normal(samples), 6)


def refusals(path: Path) -> list[str]:
    """Return what reading at once and reading in blocks say; both must refuse."""
    told = []
    for read in (read_recording, lambda one: list(sound_blocks(open_stream(one), Blocking(samples=100)))):
        with pytest.raises(RecordingError) as caught:
            read(path)
        told.append(str(caught.value))
        assert path.name in told[-1]
        assert "\n" not in told[-1]
    return told


@pytest.mark.parametrize("form", FORMATS)
def test_a_sound_recording_passes(tmp_path: Path, form: str) -> None:
    path = made(tmp_path, form, {"torque_V": torque()})
    stream = open_stream(path)
    assert read_recording(path).torque() == pytest.approx(torque(), rel=1e-6)
    assert stream_info(stream).suspicions() == []


@pytest.mark.parametrize("form", FORMATS)
def test_runs_that_are_no_numbers(tmp_path: Path, form: str) -> None:
    values = torque()
    values[120:130], values[250] = np.nan, np.nan
    path = made(tmp_path, form, {"torque_V": values})
    at_once, in_blocks = refusals(path)
    assert "the first at sample 120 (0.12 s)" in at_once
    assert "samples 120..129, 250" in at_once
    assert "the first at sample 120 (0.12 s)" in in_blocks
    assert (
        "has 11 samples that are not numbers: samples 120..129, 250" in stream_info(open_stream(path)).suspicions()[0]
    )


@pytest.mark.parametrize("form", [form for form in FORMATS if form not in ("text", "lvm", "wav")])
def test_a_rate_that_the_time_contradicts(tmp_path: Path, form: str) -> None:
    columns = {"time_s": np.arange(400) / RATE, "torque_V": torque()}
    path = made(tmp_path, form, columns, rate=1002.0, names=("torque_V",))
    for told in refusals(path):
        assert "run1.yaml (sample_rate_Hz) states 1002 samples per second and the column time_s states 1000" in told


@pytest.mark.parametrize("form", ["text", "lvm", "wav"])
def test_a_rate_that_the_file_contradicts(tmp_path: Path, form: str) -> None:
    for told in refusals(made(tmp_path, form, {"torque_V": torque()}, rate=1002.0)):
        assert "states 1002 samples per second and" in told
        assert "states 1000; correct one of them" in told


@pytest.mark.parametrize("samples", [0, 1])
@pytest.mark.parametrize("form", FORMATS)
def test_no_sample_and_one_sample(tmp_path: Path, form: str, samples: int) -> None:
    for told in refusals(made(tmp_path, form, {"torque_V": torque(samples)})):
        assert any(
            word in told
            for word in ("no samples", "one sample", "fewer than 2", "no vector of two", "not a whole WAV", "no data",
                         "is no column", "nothing in it")
        )  # fmt: skip


@pytest.mark.parametrize("form", FORMATS)
def test_a_constant_signal_is_named_and_serves(tmp_path: Path, form: str, capsys: pytest.CaptureFixture[str]) -> None:
    path = made(tmp_path, form, {"torque_V": np.full(400, 0.5)})
    assert read_recording(path).samples == 400
    main(("info", str(path)))
    assert "is constant at 0.5 V in all its" in capsys.readouterr().out
    main(("filter", str(path), "--chain", "none", "--motor", "bldc-12n14p", "--ratio", "5"))
    told = capsys.readouterr()
    assert "is constant in all its 400 samples; is the sensor connected?" in told.err
    assert "nan" not in told.out


@pytest.mark.parametrize("form", [form for form in FORMATS if form != "text"])
def test_a_channel_that_is_not_there(tmp_path: Path, form: str) -> None:
    path = made(tmp_path, form, {"torque_V": torque()}, names=("torqe_V",))
    for told in refusals(path):
        assert "there is no column 'torqe_V', which run1.yaml names" in told


@pytest.mark.parametrize("form", ["mat v5", "mat v7.3", "tdms"])
def test_channels_of_unequal_length(tmp_path: Path, form: str) -> None:
    path = made(tmp_path, form, {"torque_V": torque(), "other_V": torque(390)})
    for told in refusals(path):
        assert "unequal numbers of samples (" in told
        assert "torque_V 400" in told
        assert "other_V 390" in told


@pytest.mark.parametrize("share", [0.2, 0.6, 0.95])
@pytest.mark.parametrize("form", ["parquet", "mat v5", "mat v7.3", "tdms", "wav"])
def test_a_file_that_was_cut_short(tmp_path: Path, form: str, share: float) -> None:
    path = made(tmp_path, form, {"torque_V": torque()})
    data = path.read_bytes()
    path.write_bytes(data[: int(share * len(data))])
    for told in refusals(path):
        assert "not a whole" in told or "ends " in told
        assert "again" in told


@pytest.mark.parametrize("form", ["csv", "text", "lvm"])
def test_a_text_that_was_cut_within_a_row(tmp_path: Path, form: str) -> None:
    path = made(
        tmp_path, form, {"torque_V": torque(), "other_V": torque()} if form == "csv" else {"torque_V": torque()}
    )
    text = path.read_text().rstrip("\n")
    separator = {"csv": ",", "text": "  ", "lvm": "\t"}[form]
    path.write_text(text[: text.rindex(separator)])
    for told in refusals(path):
        assert f":{text.count(chr(10)) + 1}: the row has 1 cell" in told


@pytest.mark.parametrize("form", ["csv", "lvm"])
def test_decimal_commas_between_commas(tmp_path: Path, form: str) -> None:
    path = made(tmp_path, form, {"torque_V": torque(), "other_V": torque()})
    path.write_text(path.read_text().replace(".", ","))
    for told in refusals(path):
        assert "row has 4 cells and the table 2 columns" in told or "is no number" in told


def test_a_tdms_file_whose_writer_died_within_its_lead_in(tmp_path: Path) -> None:
    path = made(tmp_path, "tdms", {"torque_V": torque()})
    # LabVIEW writes the length of the last segment when it closes the file: until then it is -1
    data = bytearray(path.read_bytes())
    data[12:20] = struct.pack("<q", -1)
    path.write_bytes(bytes(data))
    for told in refusals(path):
        assert "ends in the middle of its last segment" in told
