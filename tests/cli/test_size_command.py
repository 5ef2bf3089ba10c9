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
