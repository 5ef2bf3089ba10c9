"""Profiles: the three of the contract by their words, duty cycles and tables by hand-made numbers; gaps are refused."""

from __future__ import annotations

from math import inf, pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.profiles.duty_cycle import Segment, duty_cycle
from torquerig.recordings.profiles.from_file import read_profile
from torquerig.recordings.profiles.ramp import Ramp
from torquerig.recordings.profiles.reversal import LINES, Reversal
from torquerig.recordings.profiles.steady import Steady
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

SPEED, LENGTH = 100.0, 8.0
WORDS = (Steady(), Ramp(), Reversal())
RPM = pi / 30


def at(profile, *times, duration=LENGTH):
    return profile.speed(np.array(times), top=SPEED, duration=duration).tolist()


def test_the_three_words_mean_what_the_contract_fixes():
    """CONTRACTS.md, section 1: ramp from 10 % to 100 %, held for the last tenth; reversal is two whole sines."""
    assert at(Steady(), 0, 3, 8) == [100, 100, 100]
    assert at(Ramp(), 0, 3.6, 7.2, 8) == pytest.approx([10, 55, 100, 100])
    assert at(Reversal(), 0, 1, 2, 3, 4) == pytest.approx([0, 100, 0, -100, 0], abs=1e-12)


@pytest.mark.parametrize("profile", WORDS, ids=lambda one: one.name)
def test_corners_draw_the_profile(profile):
    time = np.linspace(0, LENGTH, 1001)
    drawn = profile.breakpoints(top=SPEED, duration=LENGTH).speed_at(time)
    # a chord of a sine is off by at most (step angle)^2 / 8
    sag = SPEED * (4 * pi / LINES) ** 2 / 8 + 1e-9
    assert drawn == pytest.approx(profile.speed(time, top=SPEED, duration=LENGTH), abs=sag)


CYCLE = duty_cycle(
    [
        Segment(duration=2, speed=50, ramp=True, load=1.0),
        Segment(duration=3, speed=50, load=4.0),
        Segment(duration=1, speed=0, load=0.0),
    ]
)


def test_a_cycle_ramps_holds_steps_and_comes_again():
    # the ramp of the first segment starts where the last one ended: at rest
    assert at(CYCLE, 0, 1, 2, 4.999, 5, 5.5) == pytest.approx([0, 25, 50, 50, 0, 0])
    assert at(CYCLE, 7, 61, duration=70) == pytest.approx([25, 25])
    assert CYCLE.load(np.array([0.5, 2.0, 4.9, 5.0])).tolist() == [1, 4, 4, 0]
    assert (CYCLE.length, CYCLE.rows.length) == (inf, 6)


def test_a_profile_shorter_than_the_run_is_refused():
    twice = duty_cycle([Segment(duration=2, speed=50)], repeats=2)
    assert at(twice, 0, 3.9, duration=4.0) == [50, 50]
    with pytest.raises(InputError, match=r"duty_cycle ends after 4 s, and the run lasts 5 s; make the run"):
        at(twice, 0, duration=5.0)


@pytest.mark.parametrize(
    ("segments", "told"),
    [
        ([], "needs at least one segment"),
        ([Segment(duration=0, speed=1)], "segment 1 lasts 0 s"),
        ([Segment(duration=1, speed=1, load=1.0), Segment(duration=1, speed=2)], "segment 2 states no load"),
    ],
)
def test_a_broken_cycle_is_refused(segments, told):
    with pytest.raises(InputError, match=told):
        duty_cycle(segments)


def table(folder: Path, text: str, name: str = "cycle.csv") -> Path:
    (folder / name).write_text(text)
    return folder / name


def test_a_table_says_whose_speed_it_states(tmp_path):
    rows, output = read_profile(table(tmp_path, "time_s,speed_rpm,torque_Nm\n0,0,1\n2,600,3\n"))
    assert not output
    assert rows.speed_at(np.array([1.0, 9.0])) == pytest.approx([300 * RPM, 600 * RPM])
    assert rows.load_at(np.array([1.0])) == pytest.approx([2.0])
    rows, output = read_profile(table(tmp_path, "time_s;output_speed_rpm\n0;0,5\n2;10,5\n"))
    assert output
    assert rows.load is None
    assert rows.top == pytest.approx(10.5 * RPM)


EVEN = "".join(f"{0.5 * row},100\n" for row in range(20) if row not in (11, 12))
BAD = {
    "not a number": ("time_s,speed_rpm\n0,1\n1,\n2,3\n", r"cycle.csv:3: the profile has a gap: speed_rpm is no number"),
    "falls": ("# of Monday\ntime_s,speed_rpm\n0,1\n2,1\n1,3\n", r"cycle.csv:5: the time does not rise \(2 s, then 1 s"),
    "twice": ("time_s,speed_rpm\n0,1\n1,1\n1,3\n", r"cycle.csv:4: the time does not rise"),
    "jump": (
        "time_s,speed_rpm\n" + EVEN,
        r"cycle.csv:13: the profile has a gap: the time jumps from 5 s to 6.5 s in a",
    ),
    "late": ("time_s,speed_rpm\n3,1\n4,1\n", r"cycle.csv:2: the profile starts at 3 s, .*count the time from 0"),
    "one row": ("time_s,speed_rpm\n0,1\n", r"cycle.csv:2: a profile needs at least two rows"),
    "no speed": (
        "time_s,speed\n0,1\n1,1\n",
        r"needs one column of speed, speed_rpm, motor_speed_rpm, output_speed_rpm",
    ),
    "no time": ("times,speed_rpm\n0,1\n1,1\n", r"needs the column time_s; did you mean 'times'"),
    "negative": ("time_s,speed_rpm,torque_Nm\n0,1,1\n1,1,-1\n", r"cycle.csv:3: torque_Nm is negative"),
}


@pytest.mark.parametrize(("text", "told"), BAD.values(), ids=BAD)
def test_a_table_with_a_gap_is_refused_with_its_line(tmp_path, text, told):
    with pytest.raises(InputError, match=told):
        read_profile(table(tmp_path, text))


def test_corners_far_apart_are_no_gap(tmp_path):
    rows, _ = read_profile(table(tmp_path, "time_s,speed_rpm\n0,0\n1,100\n600,100\n601,0\n3600,0\n"))
    assert rows.speed_at(np.array([300.0])) == pytest.approx([100 * RPM])


def test_a_sidecar_keeps_the_points_of_a_cycle(tmp_path):
    run = Run(speed=50.0, profile="duty_cycle", set_points=CYCLE)
    made = Recording(
        sample_rate=10.0, channels={"torque_V": Channel(values=np.arange(60.0), quantity="torque", unit="V")}, run=run
    )
    written, sidecar = write_recording(made, tmp_path / "one.parquet")
    text = sidecar.read_text()
    assert "profile: duty_cycle" in text
    again = read_recording(written).run
    time = np.linspace(0, 59, 300)
    assert again.profile == "duty_cycle"
    assert again.speed_profile().speed(time, top=0, duration=60) == pytest.approx(CYCLE.speed(time, top=0, duration=60))
    assert again.speed_profile().load(time) == pytest.approx(CYCLE.load(time))


@pytest.mark.parametrize(
    ("set_point", "told"),
    [
        ("{time_s: [0, 1], speed_rpm: [5]}", "lists need the same number of points"),
        ("{time_s: [0, 2, 1], speed_rpm: [5, 5, 5]}", "starts at 0 and does not fall"),
        ("{time_s: [0, 1], speed_rpm: [5, 5], repeats: 0}", "0 is out of range"),
    ],
)
def test_a_sidecar_with_broken_points_is_refused_with_its_line(tmp_path, set_point, told):
    table(tmp_path, "torque_V\n1\n2\n", "one.csv")
    (tmp_path / "one.yaml").write_text(f"sample_rate_Hz: 10\nrun:\n  profile: csv\n  set_point: {set_point}\n")
    with pytest.raises(InputError, match=rf"one\.yaml:4: run\.set_point(\.repeats)?: .*{told}"):
        read_recording(tmp_path / "one.csv")


def test_a_sheet_that_names_a_cycle_and_not_its_points_says_so():
    with pytest.raises(InputError, match="profile is duty_cycle, and nothing states its set-points; add to run"):
        Run(profile="duty_cycle").speed_profile()
