"""What runs can tell apart: by their speeds, loads, profiles and channels."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.studio.check.runs_checked import runs_checked
from torquerig.studio.check.separable import separable, speeds_shown

DRIVE = Kinematics(pole_pairs=7, slots=12, ratio=5.0)


def run(rpm=1000.0, **conditions):
    channel = Channel(values=np.sin(np.arange(2000.0)), quantity="torque", unit="N*m")
    of = Run(speed=rpm * pi / 30, gear_ratio=5.0, **conditions)
    return Recording(sample_rate=5000.0, channels={"torque_Nm": channel}, run=of, name=f"run{rpm:g}.csv")


def test_one_speed_and_one_load_separate_little():
    found = separable(DRIVE, [run(occupancy_percent=5.0)])
    assert not any("keep their order" in one for one in found.can)
    assert any("add a run at another speed" in one for one in found.cannot)
    assert any("add an idle run" in one for one in found.cannot)
    assert any("reversal" in one for one in found.cannot)
    assert any("run1000.csv" in one for one in found.cannot)


def test_more_conditions_separate_more():
    runs = [run(1000.0, occupancy_percent=5.0), run(1210.0, occupancy_percent=0.0), run(1000.0, profile="reversal")]
    found = separable(DRIVE, runs)
    assert any("keep their order" in one for one in found.can)
    assert any("grow with the load" in one for one in found.can)
    assert any("friction, backlash" in one for one in found.can)
    assert speeds_shown(runs) == "1000, 1210 rpm"


def test_a_line_on_the_mains_is_separated_by_another_speed():
    at_50 = [run(3000.0)]  # the motor turns 50 times a second
    assert any("from the mains: on a multiple of 50 Hz in each run" in one for one in separable(DRIVE, at_50).cannot)
    both = separable(DRIVE, [*at_50, run(2700.0)])
    assert any("because another speed moves it" in one for one in both.can)


def test_lines_above_half_the_sample_rate_are_named():
    slow = replace(run(3000.0), sample_rate=500.0)
    assert any("above half the sample rate, 250 Hz" in one for one in separable(DRIVE, [slow]).cannot)


def test_the_check_of_files_is_plain_values(tmp_path):
    path = shipped_scenarios() / "wear_rig.yaml"
    write_recording(run(1000.0, occupancy_percent=5.0), tmp_path / "run.csv", overwrite=False)
    found = runs_checked(path.read_text(), path, [tmp_path / "run.csv"])
    assert found.problem == ""
    assert found.rows[0][0] == "run.csv"
    assert "wear_part.inertia" in found.fitted
    assert found.cannot


@pytest.mark.parametrize(("text", "words"), [("rig: [", "not YAML"), ("rig: {m: {kind: motr}}", "did you mean")])
def test_a_scenario_that_cannot_be_used_is_a_result(tmp_path, text, words):
    assert words in runs_checked(text, tmp_path / "rig.yaml", []).problem


def test_a_file_that_is_no_recording_is_a_result(tmp_path):
    path = shipped_scenarios() / "wear_rig.yaml"
    (tmp_path / "notes.csv").write_text("a,b\nx,y\n")
    assert "notes.csv" in runs_checked(path.read_text(), path, [tmp_path / "notes.csv"]).problem
