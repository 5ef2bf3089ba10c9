"""A recording read block by block is the one that is read at once, in every format; and so is what is written so."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pytest
from nptdms import ChannelObject, TdmsWriter
from pyarrow import parquet
from scipy.io import wavfile

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import read_recording, tdms_pieces, write_recording
from torquerig.recordings.files.block_writing import write_blocks
from torquerig.recordings.files.blocks import Block, Blocking, sound_blocks
from torquerig.recordings.files.csv import csv_pieces
from torquerig.recordings.files.stream import RecordingStream, open_stream
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

WRITTEN = [".parquet", ".csv", ".mat", ".tdms"]


def recording(samples: int = 5000) -> Recording:
    rng = np.random.default_rng(7)
    return Recording(
        sample_rate=25000.0,
        channels={
            "torque_V": Channel(values=rng.standard_normal(samples) / 3, quantity="torque", unit="V", si_per_unit=5.0),
            "encoder_count": Channel(
                values=np.arange(samples) * 11.0, quantity="motor_angle", unit="count", si_per_unit=2 * np.pi / 16384
            ),
        },
        run=Run(motor="bldc-12n14p", gear_ratio=5.0, speed=100.0),
        name="made",
    )


def joined(blocks: list[Block]) -> dict[str, np.ndarray]:
    answers = [block.without_overlap() for block in blocks]
    return {name: np.concatenate([one.channels[name].values for one in answers]) for name in answers[0].channels}


def blocks_of(stream: RecordingStream, samples: int, overlap: int) -> list[Block]:
    return list(sound_blocks(stream, Blocking(samples=samples, overlap=overlap)))


@pytest.mark.parametrize("ending", WRITTEN)
@pytest.mark.parametrize(("samples", "overlap"), [(700, 0), (700, 150), (700, 2000), (9000, 10)])
def test_blocks_join_to_the_whole(tmp_path: Path, ending: str, samples: int, overlap: int) -> None:
    path = tmp_path / f"run1{ending}"
    write_recording(recording(), path)
    stream = open_stream(path)
    whole = read_recording(path)
    assert (stream.sample_rate, stream.samples, stream.run) == (whole.sample_rate, whole.samples, whole.run)
    blocks = blocks_of(stream, samples, overlap)
    assert blocks[0].first == 0
    assert all(later.first - one.first == samples for one, later in pairwise(blocks))
    for name, values in joined(blocks).items():
        assert np.array_equal(values, whole.channels[name].values)
    for block in blocks:
        low = block.first - block.kept.start
        high = block.first + (block.kept.stop - block.kept.start) + overlap
        assert low == max(block.first - overlap, 0)
        assert np.array_equal(
            block.recording.channels["torque_V"].values, whole.channels["torque_V"].values[low : min(high, 5000)]
        )


@pytest.mark.parametrize("ending", WRITTEN)
def test_what_is_written_in_blocks_is_read_back(tmp_path: Path, ending: str) -> None:
    made = recording()
    write_recording(made, tmp_path / "source.parquet")
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        blocks = sound_blocks(open_stream(tmp_path / "source.parquet"), Blocking(samples=600))
        path, sidecar = write_blocks((block.without_overlap() for block in blocks), tmp_path / folder / f"run1{ending}")
    back = read_recording(path)
    for name, channel in made.channels.items():
        assert replace(back.channels[name], values=channel.values) == channel
        assert np.array_equal(back.channels[name].values, channel.values)
    assert (back.run, back.sample_rate) == (made.run, made.sample_rate)
    assert sorted(one.name for one in path.parent.iterdir()) == sorted([path.name, sidecar.name])
    assert path.read_bytes() == (tmp_path / "a" / path.name).read_bytes()


def test_the_last_block_reaches_back_to_a_whole_number_of_units(tmp_path: Path) -> None:
    made = recording(5003)
    write_recording(made, tmp_path / "run1.parquet")
    stream = open_stream(tmp_path / "run1.parquet")
    blocks = list(sound_blocks(stream, Blocking(samples=640, overlap=128, unit=64)))
    assert [block.recording.samples % 64 for block in blocks] == [0] * len(blocks)
    assert np.array_equal(joined(blocks)["torque_V"], made.channels["torque_V"].values)


def test_a_block_that_breaks_leaves_nothing(tmp_path: Path) -> None:
    bad = recording().with_values("torque_V", np.where(np.arange(5000) == 3210, np.nan, 0.0))
    parquet.write_table(pa.table({"torque_V": bad.channels["torque_V"].values}), tmp_path / "bad.parquet")
    (tmp_path / "bad.yaml").write_text("sample_rate_Hz: 1000\n")
    blocks = sound_blocks(open_stream(tmp_path / "bad.parquet"), Blocking(samples=500))
    with pytest.raises(RecordingError, match=r"the first at sample 3210 \(3.21 s\)"):
        write_blocks((block.without_overlap() for block in blocks), tmp_path / "out.tdms")
    assert sorted(one.name for one in tmp_path.iterdir()) == ["bad.parquet", "bad.yaml"]


def test_blocks_are_not_written_over_a_file(tmp_path: Path) -> None:
    (tmp_path / "out.tdms").write_text("kept")
    with pytest.raises(InputError, match="is there already"):
        write_blocks([recording()], tmp_path / "out.tdms")
    assert (tmp_path / "out.tdms").read_text() == "kept"


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("time_s,torque_V\n{}", ("time_s", "torque_V")),
        ("# made\ntime_s;torque_V;remark\n{}", ("time_s", "torque_V")),
        ("{}", ("time_s", "torque_V")),
        ("time_s torque_V\n{}", ("time_s", "torque_V")),
    ],
    ids=["comma", "semicolon", "bare", "blanks"],
)
def test_text_in_pieces_is_the_text_at_once(tmp_path: Path, text: str, names: tuple[str, ...]) -> None:
    rows = [(i / 1000, np.sin(i)) for i in range(400)]
    form = {"#": "{:.3f};{:.9f};word", "t": "{:.3f},{:.9f}", "{": "{:.3f} \t {:.9f} "}[text[0]]
    form = form.replace(",", "   ") if " torque" in text else form
    body = "\n".join(form.format(*row) for row in rows)
    decimal_comma = text.startswith("#")
    (tmp_path / "run1.csv").write_text(text.format(body.replace(".", ",") if decimal_comma else body))
    pieces = csv_pieces(tmp_path / "run1.csv", step=1000)
    assert pieces.names == names
    got = list(pieces.pieces(names))
    assert len(got) > 5
    for place, name in enumerate(names):
        assert np.concatenate([one[name] for one in got]) == pytest.approx([row[place] for row in rows], abs=1e-9)


def test_a_broken_row_far_into_the_text_keeps_its_line(tmp_path: Path) -> None:
    rows = [f"{i / 1000},{i}" for i in range(400)]
    rows[300] = "0.3,1,2"
    (tmp_path / "run1.csv").write_text("time_s,torque_V\n" + "\n".join(rows))
    with pytest.raises(RecordingError, match=r"run1\.csv:302: the row has 3 cells and the table 2 columns"):
        list(csv_pieces(tmp_path / "run1.csv", step=500).pieces(["torque_V"]))


@pytest.mark.parametrize("kind", [np.int16, np.uint8, np.float32, np.int32])
def test_wav_in_blocks(tmp_path: Path, kind: type) -> None:
    values = (np.random.default_rng(1).uniform(0, 100, (3000, 2))).astype(kind)
    wavfile.write(tmp_path / "run1.wav", 8000, values)
    entry = "{quantity: torque, unit: FS, Nm_per_FS: 20}"
    (tmp_path / "run1.yaml").write_text(f"channels:\n  channel_1: {entry}\n  channel_2: {entry}\n")
    whole = read_recording(tmp_path / "run1.wav")
    for name, joint in joined(blocks_of(open_stream(tmp_path / "run1.wav"), 400, 20)).items():
        assert np.array_equal(joint, whole.channels[name].values)


@pytest.mark.parametrize("shape", [(-1,), (1, -1), (-1, 1)])
def test_mat_7_3_in_blocks(tmp_path: Path, shape: tuple[int, ...]) -> None:
    values = np.random.default_rng(1).standard_normal(3000)
    with h5py.File(tmp_path / "run1.mat", "w") as file:
        file["s/torque_V"] = values.reshape(shape)
        file["fs"] = np.array([[2000.0]])
    stream = open_stream(tmp_path / "run1.mat")
    assert (stream.sample_rate, stream.samples, stream.table.read_whole) == (2000.0, 3000, "")
    assert np.array_equal(joined(blocks_of(stream, 400, 20))["torque_V"], values)


def test_formats_that_cannot_be_streamed_say_so(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run1.mat")
    assert "before v7.3 is read whole; save it with -v7.3" in open_stream(tmp_path / "run1.mat").table.read_whole
    lvm = "LabVIEW Measurement\t\n***End_of_Header***\nX_Value\ttorque_V\n0\t1\n0.1\t2\n0.2\t3\n"
    (tmp_path / "run2.lvm").write_text(lvm)
    assert "LVM file is text in segments and read whole" in open_stream(tmp_path / "run2.lvm").table.read_whole


SCALED = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Linear", "NI_Scale[0]_Linear_Slope": 2.5,
          "NI_Scale[0]_Linear_Y_Intercept": -1.0, "NI_Scale[0]_Linear_Input_Source": 0xFFFFFFFF}  # fmt: skip


@pytest.mark.parametrize("largest", [1, 10**9], ids=["fetched here", "through npTDMS"])
@pytest.mark.parametrize("properties", [{}, SCALED], ids=["plain", "scaled"])
def test_a_large_chunk_of_tdms_in_pieces(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, largest: int, properties: dict[str, object]
) -> None:
    monkeypatch.setattr(tdms_pieces, "_LARGEST_CHUNK", largest)
    monkeypatch.setattr(tdms_pieces, "PIECE", 700)
    rng = np.random.default_rng(1)
    first, second = rng.standard_normal(3000).astype(np.float32), rng.integers(-99, 99, 3000).astype(np.int16)
    with TdmsWriter(tmp_path / "run1.tdms") as writer:
        for low, high in ((0, 1300), (1300, 1900), (1900, 3000)):
            writer.write_segment(
                [
                    ChannelObject("a", "torque_V", first[low:high], {"wf_increment": 1e-3, **properties}),
                    ChannelObject("a", "current_A", second[low:high], {"wf_increment": 1e-3}),
                ]
            )
    stream = open_stream(tmp_path / "run1.tdms")
    assert stream.samples == 3000
    whole = read_recording(tmp_path / "run1.tdms")
    for name, values in joined(blocks_of(stream, 400, 20)).items():
        assert np.array_equal(values, whole.channels[name].values), name


@pytest.mark.parametrize("largest", [1, 10**9], ids=["fetched here", "through npTDMS"])
def test_interleaved_tdms_in_pieces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, largest: int) -> None:
    from nptdms.test.util import GeneratedFile, channel_metadata, segment_objects_metadata

    monkeypatch.setattr(tdms_pieces, "_LARGEST_CHUNK", largest)
    monkeypatch.setattr(tdms_pieces, "PIECE", 7)
    rows = np.zeros(50, dtype=[("a", "<i4"), ("b", "<i4")])
    rows["a"], rows["b"] = np.arange(50), 1000 + np.arange(50)
    made = GeneratedFile()
    made.add_segment(
        ("kTocMetaData", "kTocRawData", "kTocNewObjList", "kTocInterleavedData"),
        segment_objects_metadata(
            channel_metadata("/'group'/'torque_V'", 3, 10), channel_metadata("/'group'/'current_A'", 3, 10)
        ),
        rows.tobytes().hex(),
    )
    with made.get_tempfile() as file:
        (tmp_path / "run1.tdms").write_bytes(file.read())
    (tmp_path / "run1.yaml").write_text("sample_rate_Hz: 100\n")
    got = joined(blocks_of(open_stream(tmp_path / "run1.tdms"), 20, 3))
    assert np.array_equal(got["torque_V"], rows["a"])
    assert np.array_equal(got["current_A"], rows["b"])


def test_a_lost_sample_far_into_the_blocks_is_named(tmp_path: Path) -> None:
    times = np.delete(np.arange(3001) / 1000, 2500)
    parquet.write_table(pa.table({"time_s": times, "torque_V": times}), tmp_path / "run1.parquet")
    stream = open_stream(tmp_path / "run1.parquet")
    assert stream.sample_rate == 1000
    with pytest.raises(RecordingError, match=r"time_s jumps by 0.002 s instead of 0.001 s after sample 2499 \(2.499 s"):
        blocks_of(stream, 400, 20)
