"""Bad recordings: each one sentence with the file, what is wrong, where, and what to do."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from nptdms import ChannelObject, TdmsWriter
from pyarrow import parquet
from scipy.io import savemat, wavfile

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import read_recording

RATE = "sample_rate_Hz: 1000\n"


def made(folder: Path, columns: dict[str, list[float]], sidecar: str | None = RATE) -> Path:
    path = folder / "run1.parquet"
    parquet.write_table(pa.table(columns), path)
    if sidecar is not None:
        path.with_suffix(".yaml").write_text(sidecar)
    return path


def refusal(path: Path, kind: type[Exception] = RecordingError) -> str:
    with pytest.raises(kind) as caught:
        read_recording(path)
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert path.name in sentence or path.stem in sentence
    return sentence


def test_missing_file_names_the_close_one(tmp_path: Path) -> None:
    made(tmp_path, {"torque_V": [1, 2]})
    assert "there is no such file; did you mean 'run1.parquet'?" in refusal(tmp_path / "run2.parquet", InputError)
    assert "check the path" in refusal(tmp_path / "no" / "run2.parquet", InputError)


def test_unknown_ending_folder_and_sidecar(tmp_path: Path) -> None:
    (tmp_path / "run1.xyz").write_text("1")
    assert "'.xyz' is no known format of a recording; readable are .parquet, .csv" in refusal(
        tmp_path / "run1.xyz", InputError
    )
    assert "is a folder" in refusal(tmp_path, InputError)
    made(tmp_path, {"torque_V": [1, 2]})
    assert "is a sidecar; name its table file" in refusal(tmp_path / "run1.yaml", InputError)


def test_nan_names_channel_count_sample_and_time(tmp_path: Path) -> None:
    values = [0.0, 1.0, float("nan"), 3.0, float("inf"), 0.0]
    told = refusal(made(tmp_path, {"torque_V": values}))
    assert "torque_V has 2 samples not a finite number, the first at sample 2 (0.002 s)" in told
    assert ": samples 2, 4; cut the recording" in told


def test_a_missing_value_in_parquet_and_csv_is_no_number(tmp_path: Path) -> None:
    assert "torque_V has 1 sample not a finite number" in refusal(made(tmp_path, {"torque_V": [0.0, None, 1.0]}))
    (tmp_path / "b.csv").write_text("time_s,torque_V\n0,1\n0.1,\n0.2,3\n")
    assert "the first at sample 1 (0.1 s)" in refusal(tmp_path / "b.csv")


@pytest.mark.parametrize(("values", "word"), [([], "no samples"), ([1.0], "one sample")])
def test_no_or_one_sample(tmp_path: Path, values: list[float], word: str) -> None:
    path = tmp_path / "run1.parquet"
    parquet.write_table(pa.table({"torque_V": pa.array(values, pa.float64())}), path)
    path.with_suffix(".yaml").write_text(RATE)
    assert f"the recording has {word} and at least 2 are needed" in refusal(path)
    text = "time_s,torque_V\n" + "".join(f"0,{value}\n" for value in values)
    (tmp_path / "b.csv").write_text(text)
    assert word in refusal(tmp_path / "b.csv")


def test_empty_files(tmp_path: Path) -> None:
    for ending in (".csv", ".txt", ".mat", ".tdms", ".lvm", ".wav", ".parquet"):
        path = tmp_path / f"empty{ending}"
        path.write_bytes(b"")
        assert path.name in refusal(path)


def test_wrong_columns(tmp_path: Path) -> None:
    path = made(tmp_path, {"torqe_V": [1, 2]}, RATE + "channels:\n  torque_V: {quantity: torque, unit: Nm}\n")
    told = refusal(path)
    assert "there is no column 'torque_V', which run1.yaml names; did you mean 'torqe_V'?" in told


def test_a_misspelt_torque_is_no_torque(tmp_path: Path) -> None:
    recording = read_recording(made(tmp_path, {"torqe_V": [1, 2]}))
    assert recording.channels["torqe_V"].quantity == "voltage"
    with pytest.raises(RecordingError, match="there is no torque channel among torqe_V"):
        recording.torque()


def test_an_encoder_without_its_counts_is_no_angle(tmp_path: Path) -> None:
    recording = read_recording(made(tmp_path, {"torque_V": [1, 2], "encoder_count": [1, 2]}))
    assert recording.channels["encoder_count"].quantity == "other"
    assert recording.channels["encoder_count"].unit == "count"


def test_words_only(tmp_path: Path) -> None:
    assert "there is no channel of numbers" in refusal(made(tmp_path, {"remark": ["a", "b"]}))


def test_no_rate(tmp_path: Path) -> None:
    told = refusal(made(tmp_path, {"torque_V": [1, 2]}, None))
    assert "the sample rate is not stated; write it into a sidecar" in told
    assert "run1.yaml as sample_rate_Hz: NUMBER, or add a column time_s" in told


def test_sidecar_rate_against_the_time_column(tmp_path: Path) -> None:
    columns = {"time_s": [0.0, 0.001, 0.002], "torque_V": [1.0, 2.0, 3.0]}
    told = refusal(made(tmp_path, columns, "sample_rate_Hz: 1002\n"))
    assert (
        "run1.yaml (sample_rate_Hz) states 1002 samples per second and the column time_s states 1000; correct one"
        in told
    )
    # 0.05 % is rounding
    assert read_recording(made(tmp_path, columns, "sample_rate_Hz: 1000.5\n")).sample_rate == 1000.5


def test_sidecar_rate_against_the_wav_header(tmp_path: Path) -> None:
    wavfile.write(tmp_path / "run1.wav", 48000, np.zeros(4, np.int16))
    text = "sample_rate_Hz: 44100\nchannels:\n  channel_1: {quantity: torque, unit: FS, Nm_per_FS: 20}\n"
    (tmp_path / "run1.yaml").write_text(text)
    assert "states 44100 samples per second and the file's entry for channel_1 states 48000" in refusal(
        tmp_path / "run1.wav"
    )


def test_time_with_a_lost_sample(tmp_path: Path) -> None:
    time = [i / 1000 for i in range(100) if i != 40]
    told = refusal(made(tmp_path, {"time_s": time, "torque_V": [0.0] * 99}, None))
    assert "time_s is not evenly spaced" in told
    assert "the step after sample 39 is 0.002 s instead of 0.001 s" in told


def test_time_that_goes_back(tmp_path: Path) -> None:
    told = refusal(made(tmp_path, {"time_s": [0.0, 0.1, 0.05, 0.3], "torque_V": [0.0] * 4}, None))
    assert "time_s does not rise at sample 2 (0.1 s, then 0.05" in told
    assert "does not rise at sample 3" in refusal(
        made(tmp_path, {"time_s": [0.0, 0.1, 0.2, float("nan")], "torque_V": [0.0] * 4}, None)
    )


def test_unequal_lengths(tmp_path: Path) -> None:
    savemat(tmp_path / "run1.mat", {"t": np.arange(5) / 10, "torque_V": np.arange(4.0)})
    told = refusal(tmp_path / "run1.mat")
    assert "unequal numbers of samples (t 5, torque_V 4); cut them to the same span" in told


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "time_s,torque_V\n0,1\n0.1,2\n0.2\n0.3,4\n",
            "run1.csv:4: the row has 1 cell and the table 2 columns; complete",
        ),
        ("time_s,torque_V\n0,1\n\n0.1,2,3\n", "run1.csv:4: the row has 3 cells"),
        ("# a\ntime_s;torque_V\n0;1\n0,1;x2\n", "run1.csv:4: torque_V: 'x2' is no number; correct the cell"),
        ("time_s,torque_V\n0,5,1,2\n0,6,1,3\n", "(if the commas are decimal signs, separate the cells by semicolons)"),
        ("time_s;torque_V\n0,1;1.5\n0,2;1,5\n", "run1.csv:2: torque_V: '1.5' is no number"),
        ("0,1,2\n0.1,1,2\n", "run1.csv: the sample rate is not stated"),
        ("time_s,torque_V\n0,#REF!\n1,2\n", "torque_V has 1 sample not a finite number, the first at sample 0"),
        ("time_s,torque_V\n0,1.5\n1,12x\n2,2\n", "run1.csv:3: torque_V: '12x' is no number"),
        ("\0\1\2", "run1.csv: is binary, not text"),
    ],
)
def test_broken_csv_names_the_line(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "run1.csv"
    path.write_text(text)
    assert told in refusal(path)


def test_mat_without_vectors(tmp_path: Path) -> None:
    savemat(tmp_path / "run1.mat", {"kp": 3.0, "who": "me"})
    told = refusal(tmp_path / "run1.mat")
    assert "there is no vector of two or more numbers among its variables (kp: a single number; who: a text)" in told


def test_mat_without_the_expected_variable(tmp_path: Path) -> None:
    savemat(tmp_path / "run1.mat", {"t": np.arange(5) / 10, "Torque": np.arange(5.0)})
    (tmp_path / "run1.yaml").write_text("channels:\n  torque: {quantity: torque, unit: Nm}\n")
    assert "there is no column 'torque', which run1.yaml names; did you mean 'Torque'?" in refusal(
        tmp_path / "run1.mat"
    )


@pytest.mark.parametrize("ending", [".parquet", ".mat", ".tdms", ".wav"])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_a_file_that_is_cut_short(tmp_path: Path, ending: str, share: float) -> None:
    path = tmp_path / f"run1{ending}"
    values = np.random.default_rng(0).standard_normal(500)
    if ending == ".parquet":
        parquet.write_table(pa.table({"torque_V": values}), path)
    elif ending == ".mat":
        savemat(path, {"torque_V": values})
    elif ending == ".wav":
        wavfile.write(path, 1000, values)
    else:
        with TdmsWriter(path) as writer:
            writer.write_segment([ChannelObject("a", "torque_V", values, {"wf_increment": 1e-3})])
    whole = path.read_bytes()
    path.write_bytes(whole[: int(share * len(whole))])
    told = refusal(path)
    assert "not a whole" in told or "ends " in told


def test_tdms_with_a_scale_that_is_not_known(tmp_path: Path) -> None:
    scale = {"NI_Number_Of_Scales": 1, "NI_Scale[0]_Scale_Type": "Magic", "wf_increment": 1e-3}
    with TdmsWriter(tmp_path / "run1.tdms") as writer:
        writer.write_segment([ChannelObject("a", "torque_V", np.arange(9.0), scale)])
    assert "a scale that is not supported (Magic); in LabVIEW, write the scaled values" in refusal(
        tmp_path / "run1.tdms"
    )


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Something\n", "run1.lvm:1: the first line is not 'LabVIEW Measurement'"),
        ("LabVIEW Measurement\t\nSeparator\tTab\n", "it has no ***End_of_Header***"),
        ("LabVIEW Measurement\t\n***End_of_Header***\nX_Value\ta\n0\t1\n0.1\n", "run1.lvm:5: the row has 1 cells"),
        ("LabVIEW Measurement\t\n***End_of_Header***\nX_Value\ta\n0\tx1\n", "run1.lvm:4: a: 'x1' is no number"),
        (
            "LabVIEW Measurement\t\n***End_of_Header***\n0\t1\n",
            "run1.lvm:3: a row of numbers comes before the line of labels",
        ),
        ("LabVIEW Measurement\t\n***End_of_Header***\n", "there is no line of labels"),
    ],
)
def test_broken_lvm(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "run1.lvm"
    path.write_text(text)
    assert told in refusal(path)


def test_a_wav_header_without_chunks(tmp_path: Path) -> None:
    (tmp_path / "run1.wav").write_bytes(b"RIFF\x00\x00\x00\x00WAVE")
    assert "not a whole WAV file" in refusal(tmp_path / "run1.wav")


def test_a_bare_wav_is_shares_of_full_scale(tmp_path: Path) -> None:
    wavfile.write(tmp_path / "run1.wav", 48000, np.zeros(4, np.int16))
    channel = read_recording(tmp_path / "run1.wav").channels["channel_1"]
    assert (channel.quantity, channel.unit) == ("other", "FS")


@pytest.mark.parametrize("size", [0, 1, 4, 20, 27, 28, 30, 60, 100, 130])
@pytest.mark.parametrize("ending", ["tdms", "wav", "mat"])
def test_a_file_that_is_cut_in_its_header(tmp_path: Path, ending: str, size: int) -> None:
    path = tmp_path / f"run1.{ending}"
    values = np.arange(200.0)
    if ending == "tdms":
        with TdmsWriter(path) as file:
            file.write_segment([ChannelObject("recording", "torque_V", values)])
    elif ending == "wav":
        wavfile.write(path, 1000, values.astype(np.float32))
    else:
        savemat(path, {"torque_V": values})
    path.write_bytes(path.read_bytes()[:size])
    path.with_suffix(".yaml").write_text(RATE)
    assert "its source" in refusal(path) or "MATLAB" in refusal(path)
