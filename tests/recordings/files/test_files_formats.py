"""Each format that comes from other programs: values, names, rate and unit as the other program meant them."""

import os
from math import pi
from pathlib import Path

import h5py
import numpy as np
import pytest
from nptdms import ChannelObject, TdmsWriter
from scipy.io import savemat, wavfile

from torquerig.recordings.files import read_recording

SHARED = Path(__file__).resolve().parents[4] / "shared"


def beside(path: Path, text: str) -> Path:
    path.with_suffix(".yaml").write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(("case", "encoder"), [("practice1", True), ("practice2", False)])
def test_practice_recordings(case: str, encoder: bool) -> None:
    path = SHARED / "practice" / case / "run1.parquet"
    if not path.exists():
        pytest.skip("the shared practice recordings are not there")
    recording = read_recording(path)
    assert (recording.sample_rate, recording.samples) == (25000.0, 300_000)
    assert recording.run.speed_rpm == pytest.approx(1000)
    assert recording.torque_name() == "torque_V"
    assert (recording.find("motor_angle") == "encoder_count") is encoder
    if encoder:
        # the README's set-point is off by up to 0.8 %
        angle = recording.channels["encoder_count"].in_si()
        turned = (angle[-1] - angle[0]) / (2 * pi) / (recording.samples - 1) * recording.sample_rate
        assert turned * 60 == pytest.approx(1000, rel=0.008)


def test_emps_mat_v5_with_its_published_scale(tmp_path: Path) -> None:
    source = SHARED / "real-data" / "emps" / "DATA_EMPS.mat"
    if not source.exists():
        pytest.skip("the shared real data are not there")
    (tmp_path / "emps.mat").write_bytes(source.read_bytes())
    path = beside(
        tmp_path / "emps.mat",
        "channels:\n  vir: {quantity: force, unit: V, N_per_V: 35.15}\n  qm: {quantity: position, unit: m}\n",
    )
    recording = read_recording(path)
    assert (recording.sample_rate, recording.samples) == (1000.0, 24841)
    assert np.ptp(recording.channels["qm"].in_si()) == pytest.approx(0.25, rel=0.05)  # stroke of the README


CSV = {
    "comma": ("time_s,torque_V\n", "{0:.6f},{1:.12g}\n", "."),
    "semicolon and decimal comma": ("time_s;torque_V\n", "{0:.6f};{1:.12g}\n", ","),
    "tab and decimal comma": ("time_s\ttorque_V\r\n", "{0:.6f}\t{1:.12g}\r\n", ","),
    "quoted header, blanks": ('"time_s", "torque_V"\n', "{0:.6f}, {1:.12g}\n", "."),
    "byte order mark, remark, plus sign": ("\ufeff# rig 3\ntime_s,torque_V\n", "+{0:.6f},{1:.12g}\n", "."),
    "bare, blanks": ("", "  {0:.6f}   {1:.12g}\n", "."),
    "bare, tab": ("% made by LabVIEW\n", "{0:.6f}\t{1:.12g}\n", "."),
    "bare, decimal comma": ("", "{0:.6f}\t{1:.12g}\n", ","),
    "bare, blanks and decimal comma": ("", "{0:.6f} {1:.12g}\n", ","),
    "bare, commas": ("", "{0:.6f},{1:.12g}\n", "."),
}


@pytest.mark.parametrize("kind", CSV)
@pytest.mark.parametrize("ending", [".csv", ".txt"])
def test_text_tables(tmp_path: Path, kind: str, ending: str) -> None:
    header, row, decimal = CSV[kind]
    torque = np.sin(np.arange(200) / 7) - 0.3
    rows = [row.format(0.5 + i / 25000, value) for i, value in enumerate(torque)]
    text = header + "".join(one.replace(".", decimal) for one in rows)
    path = tmp_path / f"run1{ending}"
    path.write_bytes(text.encode())
    recording = read_recording(path)
    assert recording.sample_rate == 25000.0
    channel = recording.channels["torque_V"]
    assert (channel.quantity, channel.unit, channel.si_per_unit) == ("torque", "V", 1.0)
    np.testing.assert_allclose(channel.values, torque, rtol=0, atol=1e-11)


def test_csv_with_words_several_units_and_a_separator_at_the_end(tmp_path: Path) -> None:
    path = tmp_path / "run1.csv"
    path.write_text("time_s,torque_mNm,speed_rpm,motor_speed_rad_s,remark,\n0,1,60,1,idle,\n0.01,2,60,1,idle,\n")
    recording = read_recording(path)
    assert list(recording.channels) == ["torque_mNm", "speed_rpm", "motor_speed_rad_s"]
    assert recording.sample_rate == 100.0
    np.testing.assert_allclose(recording.torque(), [1e-3, 2e-3], rtol=1e-15)
    np.testing.assert_allclose(recording.channels["speed_rpm"].in_si(), 2 * pi, rtol=1e-15)
    assert recording.channels["motor_speed_rad_s"].unit == "rad/s"


def test_sidecar_chooses_among_the_columns(tmp_path: Path) -> None:
    (tmp_path / "run1.csv").write_text("Time, Position, Iq\n0.0, 1.5, 0.1\n0.001, 1.6, 0.2\n0.002, 1.7, 0.2\n")
    path = beside(tmp_path / "run1.csv", "channels:\n  Iq: {quantity: current, unit: A}\n")
    recording = read_recording(path)
    assert recording.sample_rate == 1000.0
    assert list(recording.channels) == ["Iq"]


def test_a_coarsely_printed_time_still_gives_the_rate(tmp_path: Path) -> None:
    # 12.8 kHz in microseconds: steps of 78 and 79 us
    rows = "".join(f"{i / 12800:.6f},{i % 7}\n" for i in range(2000))
    (tmp_path / "run1.csv").write_text("time_s,torque_Nm\n" + rows)
    assert read_recording(tmp_path / "run1.csv").sample_rate == 12800.0


def test_one_column_with_its_rate_in_the_sidecar(tmp_path: Path) -> None:
    (tmp_path / "run1.txt").write_text("0.5\n0.25\n0.125\n")
    recording = read_recording(beside(tmp_path / "run1.txt", "sample_rate_Hz: 25000\n"))
    assert recording.channels["torque_V"].values.tolist() == [0.5, 0.25, 0.125]
    (tmp_path / "run2.csv").write_text("torque_Nm\n0,5\n0,25\n")
    recording = read_recording(beside(tmp_path / "run2.csv", "sample_rate_Hz: 25000\n"))
    assert recording.channels["torque_Nm"].values.tolist() == [0.5, 0.25]


@pytest.mark.parametrize("shape", ["rows", "columns", "struct", "matrix"])
def test_mat_v5_shapes(tmp_path: Path, shape: str) -> None:
    time, torque = np.arange(50) / 1000, np.sin(np.arange(50))
    content = {
        "rows": {"t": time, "torque_V": torque, "who": "me", "kp": 3.0},
        "columns": {"time": time[:, None], "torque_V": torque[:, None]},
        "struct": {"data": {"time_s": time, "torque_V": torque}},
        "matrix": {"data": np.column_stack([time, torque])},
    }[shape]
    savemat(tmp_path / "run1.mat", content)
    recording = read_recording(tmp_path / "run1.mat")
    assert recording.sample_rate == 1000.0
    assert np.array_equal(recording.channels["torque_V"].values, torque)


@pytest.mark.parametrize("struct", [False, True])
def test_mat_v73(tmp_path: Path, struct: bool) -> None:
    torque = np.sin(np.arange(50))
    path = tmp_path / "run1.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        group = file.create_group("rig") if struct else file
        group["torque_V"] = torque[None, :]
        group["t"] = (np.arange(50) / 1000)[None, :]
        group["name"] = np.frombuffer(b"b\0l\0", dtype=np.uint16)
        group["name"].attrs["MATLAB_class"] = np.bytes_("char")
        file.create_group("#refs#")["a"] = np.arange(3.0)
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\x00\x02IM")
    recording = read_recording(path)
    assert recording.sample_rate == 1000.0
    assert list(recording.channels) == ["torque_V"]
    assert np.array_equal(recording.channels["torque_V"].values, torque)


def test_tdms_with_unit_scale_and_two_groups(tmp_path: Path) -> None:
    linear = {
        "NI_Number_Of_Scales": 1,
        "NI_Scale[0]_Scale_Type": "Linear",
        "NI_Scale[0]_Linear_Slope": 0.5,
        "NI_Scale[0]_Linear_Y_Intercept": 1.0,
        "NI_Scale[0]_Linear_Input_Source": 0xFFFFFFFF,
    }
    waveform = {"wf_increment": 1 / 51200}
    with TdmsWriter(tmp_path / "run1.tdms") as writer:
        for part in (np.arange(4), np.arange(4, 6)):
            writer.write_segment(
                [
                    ChannelObject("rig", "Torque", part.astype(np.int16), {**waveform, **linear, "unit_string": "Nm"}),
                    ChannelObject("rig", "remark", ["a"], {}),
                ]
            )
    recording = read_recording(tmp_path / "run1.tdms")
    assert recording.sample_rate == 51200.0
    assert recording.channels["Torque"].values.tolist() == [1.0, 1.5, 2.0, 2.5, 3.0, 3.5]
    with TdmsWriter(tmp_path / "run2.tdms") as writer:
        writer.write_segment([ChannelObject(group, "x", np.arange(3.0), waveform) for group in ("a", "b")])
    path = beside(tmp_path / "run2.tdms", "channels:\n  b/x: {quantity: force, unit: kN}\n")
    assert read_recording(path).torque().tolist() == [0.0, 1000.0, 2000.0]


LVM = """LabVIEW Measurement\t
Writer_Version\t2
Reader_Version\t2
Separator\tTab
Decimal_Separator\t{decimal}
Multi_Headings\tNo
X_Columns\t{columns}
Time_Pref\tRelative
***End_of_Header***\t
\t
Channels\t2\t\t
Samples\t3\t3\t
Y_Unit_Label\tVolts\trpm\t
X_Dimension\tTime\tTime\t
X0\t0{decimal}0\t0{decimal}0\t
Delta_X\t4{decimal}0E-5\t4{decimal}0E-5\t
***End_of_Header***\t\t\t
"""


@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("columns", ["One", "No", "Multi"])
def test_lvm(tmp_path: Path, decimal: str, columns: str) -> None:
    rows = {
        "One": "X_Value\tTorque\tSpeed\tComment\n0.00000\t0.5\t60\thello\n0.00004\t-1.5\t60\n0.00008\t2.5E-1\t60\n",
        "No": "X_Value\tTorque\tSpeed\tComment\n\t0.5\t60\n\t-1.5\t60\n\t2.5E-1\t60\n",
        "Multi": "X_Value\tTorque\tX_Value\tSpeed\tComment\n"
        "0.0\t0.5\t0.0\t60\n0.00004\t-1.5\t0.00004\t60\n0.00008\t2.5E-1\t0.00008\t60\n",
    }[columns]
    path = tmp_path / "run1.lvm"
    path.write_text(LVM.format(decimal=decimal, columns=columns) + rows.replace(".", decimal))
    recording = read_recording(path)
    assert recording.sample_rate == 25000.0
    assert recording.channels["Torque"].values.tolist() == [0.5, -1.5, 0.25]
    assert recording.channels["Torque"].unit == "V"
    assert recording.channels["Speed"].in_si() == pytest.approx(2 * pi)


def test_lvm_segments_follow_one_another(tmp_path: Path) -> None:
    head = LVM.format(decimal=".", columns="One")
    segment = head[head.index("Channels") :]
    first = "X_Value\tTorque\tSpeed\tComment\n0.00000\t1\t60\n0.00004\t2\t60\n\n"
    later = "X_Value\tTorque\tSpeed\tComment\n0.00008\t3\t60\n0.00012\t4\t60\n"
    path = tmp_path / "run1.lvm"
    path.write_text(head + first + segment + later)
    recording = read_recording(path)
    assert recording.channels["Torque"].values.tolist() == [1, 2, 3, 4]
    assert recording.sample_rate == 25000.0


@pytest.mark.parametrize(
    ("samples", "shares"),
    [
        (np.array([-32768, 0, 16384], np.int16), [-1.0, 0.0, 0.5]),
        (np.array([0, 128, 192], np.uint8), [-1.0, 0.0, 0.5]),
        (np.array([-(2**31), 0, 2**30], np.int32), [-1.0, 0.0, 0.5]),
        (np.array([-2.0, 0.0, 0.5], np.float32), [-2.0, 0.0, 0.5]),
    ],
)
def test_wav_is_in_shares_of_full_scale(tmp_path: Path, samples: np.ndarray, shares: list[float]) -> None:
    path = tmp_path / "run1.wav"
    wavfile.write(path, 48000, np.column_stack([samples, samples]))
    beside(path, "channels:\n  channel_2: {quantity: torque, unit: FS, Nm_per_FS: 20}\n")
    recording = read_recording(path)
    assert recording.sample_rate == 48000.0
    assert recording.channels["channel_2"].values.tolist() == shares
    assert recording.torque() == pytest.approx(20 * np.array(shares))


def test_endings_in_capitals(tmp_path: Path) -> None:
    (tmp_path / "RUN1.CSV").write_text("time_s,torque_V\n0,1\n0.1,2\n")
    assert read_recording(tmp_path / "RUN1.CSV").sample_rate == 10.0


def test_nothing_is_printed_by_a_library(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    with TdmsWriter(tmp_path / "run1.tdms") as writer:
        writer.write_segment([ChannelObject("a", "torque_V", np.arange(3.0), {"wf_increment": 0.1})])
    with (tmp_path / "run1.tdms").open("r+b") as file:
        file.truncate(os.path.getsize(tmp_path / "run1.tdms") - 3)  # noqa: PTH202
    with pytest.raises(Exception, match="run1"):
        read_recording(tmp_path / "run1.tdms")
    assert capfd.readouterr() == ("", "")
