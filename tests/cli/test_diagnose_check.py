"""``torquerig diagnose`` from the command line: what the runs would show, held-out recordings, refusals."""

from __future__ import annotations

import json

import pytest

from tests.inference.pump_bench import pump_scenario, recorded
from torquerig.cli import main
from torquerig.recordings.files.writing import write_recording


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("pump")
    for run in recorded(pump_scenario(made)):
        write_recording(run, made / run.name)
    return made


def called(folder, *options):
    runs = [str(folder / f"run{number}.parquet") for number in (1, 2)]
    arguments = ["diagnose", *runs, "--scenario", str(folder / "scenario.yaml"), *options]
    main(arguments)


@pytest.mark.long
def test_the_check_lists_what_the_runs_would_show(folder, capsys):
    out = folder / "check.json"
    called(folder, "--check", "--json", str(out))
    lines = capsys.readouterr().out.splitlines()
    assert any(line.startswith("mains interference  amplitude_V ") for line in lines)
    assert "scenario and recordings match; no diagnosis was made" in lines
    data = json.loads(out.read_text())
    limits = {each["mechanism"]: each for each in data["upper_limits"]}
    # white noise of 0.002 V rms alone would hide some 0.1 mV, the hits of the load hide more
    assert 1e-4 < limits["mains_interference"]["value"] < 5e-3
    assert limits["sensor_bandwidth"]["grows"] == "down"
    assert all(set(each["mechanisms"]) for each in data["inseparable"])


@pytest.mark.long
def test_a_whole_recording_can_be_held_out(folder):
    out = folder / "held.json"
    called(folder, "--held-out", str(folder / "run2.parquet"), "--json", str(out))
    data = json.loads(out.read_text())
    assert [each["used_for"] for each in data["recordings"]] == ["fit", "held_out"]
    assert [each["file"] for each in data["rms"]["recordings"]] == ["run2.parquet"]
    assert data["verdict"] == "adequate"
    assert 0.5 < data["fit"]["after"]["heldout_misfit"] < 1.6  # some 120 features of another speed
    assert data["provenance"]["options"]["held-out"] == ["run2.parquet"]


@pytest.mark.parametrize(
    ("options", "text"),
    [
        (("--held-out", "run9.parquet"), "no recording has this name"),
        (("--check", "--held-out", "run9.parquet"), "no recording has this name"),
        (("--held-out", "run1.parquet", "--held-out", "run2.parquet"), "leave at least one"),
    ],
)
def test_held_out_recordings_that_cannot_be_are_refused(folder, options, text, capsys):
    with pytest.raises(SystemExit, match="2"):
        called(folder, *options)
    (said,) = [line for line in capsys.readouterr().err.splitlines() if line.startswith("torquerig: ")]
    assert text in said


def test_the_check_refuses_to_write_over_a_foreign_page(folder, capsys):
    page = folder / "mine.html"
    page.write_text("<p>not a diagnosis</p>", encoding="utf-8")
    with pytest.raises(SystemExit, match="2"):
        called(folder, "--check", "--report", str(page))
    assert "mine.html" in capsys.readouterr().err
