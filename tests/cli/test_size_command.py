"""``torquerig size``: what is printed, drawn and refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main

WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def said(capsys, *arguments: str, code: int = 0) -> str:
    try:
        main(arguments)
        ended = 0
    except SystemExit as end:
        ended = end.code or 0
    streams = capsys.readouterr()
    assert ended == code, streams.err
    assert not (code and streams.out)
    return streams.err if code else streams.out


def test_a_servo_on_the_duty_cycle(capsys):
    text = said(capsys, "size", WEAR_RIG, "--motor", "HDS6A-0104A", "--gearbox", "economy-5-1", "--picture", "size.png")
    assert text.startswith("HDS6A-0104A, 5:1, duty_cycle, 300 s, repeated without end, ambient 40 °C")
    assert "largest input speed of economy-5-1" in text.split("ask for", 1)[1]
    assert "Alpha-beta: 30:1, limited by the motor speed" in text
    assert "order_lines" in text
    assert Path("size.png").stat().st_size > 20_000
    assert "is there already" in said(capsys, "size", WEAR_RIG, "--picture", "size.png", code=2)


@pytest.mark.long
def test_every_drive_in_one_table(capsys):
    text = said(capsys, "size", WEAR_RIG, "--all", "--set", "study.motors=[bldc-12n14p, ESM04X-101-302, GP-71M]")
    rows = {line.split("  ")[0]: line for line in text.splitlines()}
    assert "exceeds" in rows["ESM04X-101-302 2.5:1"]  # 100 W cannot give 3.8 N m at 2.5:1 all day
    assert "unsure" in rows["ESM04X-101-302 20:1"]
    assert "GP-71M 20:1: needs 4000 rpm, reaches at most 3000 rpm" in text


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--all", "--motor", "REF"), "remove --motor, --gearbox and --picture"),
        (("--picture", "size.pdf"), "written as .svg or .png"),
        (("--motor", "HDS6A-0104B"), "HDS6A-0104A"),
    ],
)
def test_what_is_refused(capsys, arguments, told):
    assert told in said(capsys, "size", WEAR_RIG, *arguments, code=2)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--shell", "drive.xml"), "a shell is written as .json or .aasx"),
        (("--shell", "here.json"), "here.json: is there already; overwrite it with --force"),
        (("--all", "--shell", "drive.json"), "and --shell"),
    ],
)
def test_a_shell_that_cannot_be_written_is_refused_before_the_sizing(capsys, arguments, told):
    Path("here.json").write_text("{}", encoding="utf-8")
    assert told in said(capsys, "size", WEAR_RIG, *arguments, code=2)
    assert Path("here.json").read_text(encoding="utf-8") == "{}"


@pytest.mark.long
def test_a_shell_of_a_table_profile_holds_the_motion(capsys):
    table = "time_s,output_speed_rpm,torque_Nm\n0,0,1\n1,200,1\n6,200,3.8\n"
    Path("cycle.csv").write_text(table, encoding="utf-8")
    drive = ("--motor", "HDS6A-0104A", "--gearbox", "reference-5-1")
    text = said(capsys, "size", WEAR_RIG, *drive, "--profile", "cycle.csv", "--shell", "drive.aasx")
    assert "drive.aasx: written\n" in text
    said(capsys, "catalog", "import", "drive.aasx", "axis")
    assert Path("axis/profile.csv").read_text(encoding="utf-8") == table
    assert 'ManufacturerOrderCode "HDS6A-0104A"' in Path("axis/requirements.yaml").read_text(encoding="utf-8")
    text = said(capsys, "size", WEAR_RIG, *drive, "--shell", "drive.json")
    assert "drive.json: written; without the motion of the load, which only .aasx holds" in text
