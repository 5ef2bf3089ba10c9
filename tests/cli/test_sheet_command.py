"""``torquerig info`` and ``torquerig sheet`` on files that do not say all that is needed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from nptdms import ChannelObject, TdmsWriter

from torquerig.cli import main
from torquerig.recordings.files import read_recording
from torquerig.recordings.recording import Channel, Recording


@pytest.fixture
def foreign(tmp_path: Path) -> Path:
    """A logger's TDMS file: two voltage inputs without a scale, a torque, no rate."""
    path = tmp_path / "run.tdms"
    level = np.linspace(1.0, 2.0, 50)
    with TdmsWriter(path) as file:
        file.write_segment([
            ChannelObject("log", "Dev1/ai0", level, {"unit_string": "Volts"}),
            ChannelObject("log", "Drehmoment", 2 * level, {"unit_string": "N-m"}),
            ChannelObject("log", "Weight", level, {"unit_string": "stone"}),
        ])  # fmt: skip
    return path


def test_info_shows_every_column_of_a_file_that_cannot_be_used_yet(
    foreign: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    main(("info", str(foreign)))
    shown = capsys.readouterr().out
    lines = {line.split()[0]: line.split()[1:3] for line in shown.splitlines() if line.split()}
    assert lines["Dev1/ai0"] == ["voltage", "V"]
    assert lines["Drehmoment"] == ["torque", "N*m"]
    assert lines["Weight"] == ["other", "stone"]
    assert "cannot be used yet" in shown
    assert "sample rate is not stated" in " ".join(shown.split())


def test_a_draft_opens_the_file_after_one_edit(foreign: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(("sheet", str(foreign)))
    draft = foreign.with_suffix(".yaml")
    assert "complete its 1 lines with EDIT" in capsys.readouterr().out
    draft.write_text(draft.read_text().replace("# EDIT: sample_rate_Hz: NUMBER", "sample_rate_Hz: 500"))
    recording = read_recording(foreign)
    assert recording.sample_rate == 500
    assert recording.torque().max() == 4.0
    assert recording.channels["Weight"].unit == "stone"


def test_a_draft_guesses_no_scale(tmp_path: Path) -> None:
    path = tmp_path / "run.csv"
    path.write_text("time_s,Torque [mV],encoder_count\n0,1,0\n0.001,2,5\n0.002,3,9\n")
    main(("sheet", str(path)))
    text = path.with_suffix(".yaml").read_text()
    assert "{quantity: torque, unit: mV, Nm_per_mV: NUMBER}" in text
    assert "{quantity: motor_angle, unit: count, counts_per_rev: NUMBER}" in text
    channels = read_recording(path).channels
    assert {name: one.quantity for name, one in channels.items()} == {"Torque": "voltage", "encoder_count": "other"}


def test_a_draft_overwrites_nothing(foreign: Path, capsys: pytest.CaptureFixture[str]) -> None:
    foreign.with_suffix(".yaml").write_text("sample_rate_Hz: 10\n")
    with pytest.raises(SystemExit) as stopped:
        main(("sheet", str(foreign)))
    assert stopped.value.code == 2
    assert foreign.with_suffix(".yaml").read_text() == "sample_rate_Hz: 10\n"
    assert "is there already" in capsys.readouterr().err


@pytest.mark.parametrize(
    "name", ["a b", "x: y", "# 1", "'q'", '"q"', "no", "1e5", "[x]", "{y}", "Größe", "a, b", "-", "~"]
)
def test_a_draft_of_any_name_is_read_back(tmp_path: Path, name: str) -> None:
    path = tmp_path / "run.tdms"
    with TdmsWriter(path) as file:
        file.write_segment([ChannelObject("log", name, np.arange(3.0), {"wf_increment": 0.1})])
    main(("sheet", str(path)))
    assert list(read_recording(path).channels) == [name]


def test_a_folder_stands_for_its_recordings_and_json_holds_them(
    foreign: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (foreign.parent / "b.csv").write_text("time_s,torque_Nm\n0,1\n1,2\n2,3\n")
    main(("info", str(foreign.parent), "--json"))
    first, second = json.loads(capsys.readouterr().out)["recordings"]
    assert (Path(first["path"]).name, Path(second["path"]).name) == ("b.csv", "run.tdms")
    assert first["columns"][0] | {"mean": 2.0, "sample_rate_Hz": 1.0, "samples": 3} == first["columns"][0]
    assert second["problem"]
    assert first["problem"] == ""
    assert first["sample_rate_Hz"] == 1.0
    assert first["motor_speed_rpm"] is None
    assert first["suspicions"] == []


def test_an_empty_folder_is_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(("info", str(tmp_path)))
    assert stopped.value.code == 2
    assert "there is no recording in this folder" in capsys.readouterr().err


def test_info_names_a_possible_alias(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    times = np.arange(8000) / 1000
    torque = 2 + 0.2 * np.cos(2 * np.pi * 840 * times) + 0.01 * np.random.default_rng(3).standard_normal(8000)
    rows = "".join(f"{t:.3f},{v:.5f},{3600 * t:.4f}\n" for t, v in zip(times, torque, strict=True))
    (tmp_path / "run.csv").write_text("Time [s],Torque [Nm],Motor angle [deg]\n" + rows)
    (tmp_path / "run.yaml").write_text("run: {motor: bldc-12n14p, gear_ratio: 1, speed_rpm: 600}\n")
    main(("info", str(tmp_path / "run.csv")))
    shown = " ".join(capsys.readouterr().out.split())
    assert "may be the alias of cogging x1 at 840 Hz, above half the sample rate" in shown


def test_a_chosen_sensor_is_not_compared_with_the_load_at_another(tmp_path: Path) -> None:
    """The true load is counted at the compared place; at a sensor before a gear it is another torque."""

    def torque(of: str | None = None, role: str | None = None, *, truth: bool = False) -> Channel:
        return Channel(values=np.ones(9), quantity="torque", unit="N*m", of=of, role=role, truth=truth)

    made = Recording(
        sample_rate=1000.0,
        channels={
            "outer": torque("outer", "compared"), "inner": torque("inner"), "true_load_Nm": torque(truth=True),
            "true_sensor_torque_Nm": torque("outer", truth=True), "true_at": torque("inner", truth=True),
        },
    )  # fmt: skip
    assert "true_load_Nm" in made.comparing("outer").channels
    other = made.comparing("inner")
    assert other.torque_name() == "inner"
    assert set(other.channels) == {"outer", "inner", "true_sensor_torque_Nm", "true_at"}


def test_a_motor_that_the_catalog_does_not_have_is_no_reason_to_stop(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows = "".join(f"{n / 1000:.3f},{np.sin(n)},1000\n" for n in range(3000))
    (tmp_path / "run.csv").write_text("Time [s],Torque [Nm],Motor speed [rpm]\n" + rows)
    (tmp_path / "run.yaml").write_text("run: {motor: of-my-own, gear_ratio: 1}\n")
    main(("filter", str(tmp_path / "run.csv"), "--chain", "low_pass_20Hz"))
    said = " ".join(capsys.readouterr().out.split())
    assert "the sidecar's motor 'of-my-own' is not in the catalog" in said


def test_two_torques_are_refused_until_one_has_the_role(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = "".join(f"{n / 1000:.3f},{n % 7},{n % 5},1000\n" for n in range(3000))
    (tmp_path / "run.csv").write_text("Time [s],Torque A1 [Nm],Torque B2 [Nm],Speed [rpm]\n" + rows)
    main(("info", str(tmp_path / "run.csv")))
    assert "several channels are a torque: Torque A1, Torque B2; write role: compared" in capsys.readouterr().out
    for command in (("filter", "--chain", "order_lines"), ("filter", "--chain", "order_lines", "--block", "1 s"),
                    ("ordermap",)):  # fmt: skip
        with pytest.raises(SystemExit) as stopped:
            main((command[0], str(tmp_path / "run.csv"), *command[1:]))
        assert stopped.value.code == 2
        said = " ".join(capsys.readouterr().err.split())
        assert "run.csv: several channels are a torque: Torque A1, Torque B2; name the one" in said
        main((command[0], str(tmp_path / "run.csv"), *command[1:], "--channel", "Torque B2"))
        assert "several channels" not in capsys.readouterr().out
    entries = "  Torque B2: {quantity: torque, unit: N*m, role: compared}\n  Torque A1: {quantity: torque, unit: N*m}\n"
    (tmp_path / "run.yaml").write_text("channels:\n" + entries + "  Speed: {quantity: speed, unit: rpm}\n")
    main(("info", str(tmp_path / "run.csv")))
    shown = capsys.readouterr().out
    assert "several channels" not in shown
    assert "Torque B2  torque    N*m   compared" in shown
    assert read_recording(tmp_path / "run.csv").torque_name() == "Torque B2"
