"""Which sidecar belongs to which file, and the keys of a sidecar beyond quantity and unit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from torquerig.cli import main
from torquerig.errors import InputError
from torquerig.recordings.files import open_stream, read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording

CSV = "time_s,torque_Nm\n0,1\n0.001,2\n0.002,3\n"


def put(folder: Path, **files: str) -> None:
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)


def test_a_sidecar_of_the_mat_is_not_that_of_the_csv(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="sample_rate_Hz: 500\nchannels: {x: {quantity: torque, unit: N*m}}\n")
    savemat(tmp_path / "run.mat", {"x": np.arange(5.0)})
    assert read_recording(tmp_path / "run.csv").sample_rate == pytest.approx(1000)
    assert any("is taken for that of run.mat" in note for note in open_stream(tmp_path / "run.csv").table.notes)
    assert read_recording(tmp_path / "run.mat").sample_rate == 500


def test_a_sidecar_whose_columns_both_have_serves_both(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="channels: {torque_Nm: {quantity: torque, unit: N*m, tare: true}}\n")
    savemat(tmp_path / "run.mat", {"torque_Nm": np.arange(5.0), "fs": 100.0})
    assert read_recording(tmp_path / "run.csv").channels["torque_Nm"].tare
    assert read_recording(tmp_path / "run.mat").channels["torque_Nm"].tare


def test_a_sidecar_without_a_namesake_still_must_fit(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="channels: {x: {quantity: torque, unit: N*m}}\n")
    with pytest.raises(Exception, match=r"which run\.yaml names"):
        read_recording(tmp_path / "run.csv")


def test_the_sidecar_of_one_format_goes_first(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="run: {speed_rpm: 100}\n", run__csv__yaml="run: {speed_rpm: 200}\n")
    assert read_recording(tmp_path / "run.csv").run.speed_rpm == pytest.approx(200)


def test_writing_another_format_leaves_the_first_sidecar_alone(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="run: {speed_rpm: 100}\n")
    recording = read_recording(tmp_path / "run.csv")
    written = write_recording(recording, tmp_path / "run.parquet")
    assert written[1].name == "run.parquet.yaml"
    assert (tmp_path / "run.yaml").read_text() == "run: {speed_rpm: 100}\n"
    assert read_recording(tmp_path / "run.parquet").run == recording.run


def test_all_keys_of_a_channel_are_written_and_read_back(tmp_path: Path) -> None:
    channels = {
        "set": Channel(values=np.arange(4.0), quantity="torque", unit="N*m", role="input", of="brake"),
        "shaft": Channel(
            values=np.ones(4), quantity="torque", unit="N*m", role="compared", of="torque_sensor", tare=True
        ),
    }
    recording = Recording(sample_rate=10.0, channels=channels)
    write_recording(recording, tmp_path / "run.parquet")
    read = read_recording(tmp_path / "run.parquet")
    assert read.torque_name() == "shaft"
    for name, one in channels.items():
        back = read.channels[name]
        assert (back.role, back.of, back.tare) == (one.role, one.of, one.tare)


def test_an_input_is_never_taken_for_the_measured_torque(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="channels: {torque_Nm: {quantity: torque, unit: N*m, role: input}}\n")
    with pytest.raises(Exception, match="there is no torque channel"):
        read_recording(tmp_path / "run.csv").torque()


def test_the_encoder_s_counts_scale_its_channel(tmp_path: Path) -> None:
    csv = "time_s,torque_Nm,enc\n0,1,0\n0.1,2,1024\n0.2,3,2048\n"
    channels = "channels:\n  torque_Nm: {quantity: torque, unit: N*m}\n  enc: {quantity: motor_angle, unit: count}\n"
    put(tmp_path, run__csv=csv, run__yaml=channels + "encoder: {counts_per_rev: 4096}\n")
    angle = read_recording(tmp_path / "run.csv").channels["enc"].in_si()
    assert angle == pytest.approx(np.array([0, np.pi / 2, np.pi]))


def test_an_encoder_without_its_channel_is_refused(tmp_path: Path) -> None:
    put(tmp_path, run__csv=CSV, run__yaml="encoder: {counts_per_rev: 4096}\n")
    with pytest.raises(InputError, match=r"run\.yaml:1: encoder: no channel is an angle in counts"):
        read_recording(tmp_path / "run.csv")


def test_teeth_in_the_sidecar_name_the_mesh_and_are_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    times = np.arange(4000) / 1000
    torque = 2 + 0.3 * np.cos(2 * np.pi * 10 * times * 18) + 0.01 * np.random.default_rng(1).standard_normal(4000)
    rows = "".join(f"{t:.3f},{v:.5f},600\n" for t, v in zip(times, torque, strict=True))
    put(tmp_path, run__csv="Time [s],Torque [Nm],Motor speed [rpm]\n" + rows)
    put(tmp_path, run__yaml="teeth: {pinion: 18, wheel: 54}\nrun: {speed_rpm: 600}\n")
    main(("ordermap", str(tmp_path / "run.csv")))
    assert "gear mesh x1" in capsys.readouterr().out
    write_recording(read_recording(tmp_path / "run.csv"), tmp_path / "b.parquet")
    assert read_recording(tmp_path / "b.parquet").run.others["teeth"] == {"pinion": 18, "wheel": 54}
    put(tmp_path, run__yaml="teeth: {pinion: 18}\n")
    with pytest.raises(SystemExit):
        main(("ordermap", str(tmp_path / "run.csv")))
    assert "teeth in the sidecar: the set of teeth {'pinion': 18} has no wheel" in capsys.readouterr().err
