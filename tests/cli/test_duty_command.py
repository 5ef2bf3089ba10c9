"""``torquerig duty`` and the profiles of ``simulate``: what is printed, drawn, flagged and refused."""

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


def figure_of(text: str, name: str) -> list[str]:
    return next(line for line in text.splitlines() if line.startswith(name))[len(name) :].split()


def test_a_cycle_of_the_wear_rig(capsys):
    text = said(capsys, "duty", WEAR_RIG, "--profile", "duty_cycle", "--picture", "duty.png")
    assert text.startswith("bldc-12n14p, 5:1, duty_cycle, 300 s, repeated without end, ambient 40 °C")
    assert "Safe: the winding stays below its limit of 130..155 C" in text
    nominal, low, high = map(float, figure_of(text, "winding, highest, settled C"))
    assert 40 < low < nominal < high < 130
    assert "not in the catalog; trend of the premo motors" in text
    assert Path("duty.png").stat().st_size > 10_000
    assert "is there already" in said(capsys, "duty", WEAR_RIG, "--picture", "duty.png", code=2)


def test_a_steady_duty_is_warmer_in_warmer_surroundings_by_more_than_the_difference(capsys):
    cool = said(capsys, "duty", WEAR_RIG, "--ambient", "20", "--set", "load.occupancy=21")
    warm = said(capsys, "duty", WEAR_RIG, "--ambient", "60", "--set", "load.occupancy=21")
    name = "winding, highest, settled C"
    assert float(figure_of(warm, name)[0]) > float(figure_of(cool, name)[0]) + 40
    assert "flagged: bldc-12n14p has an rms torque of 0.857 N*m, which may exceed its rated" in cool


def test_a_motor_too_small_is_told(capsys):
    hot = ("load.mean_by_occupancy_percent={0: 4 N*m, 21: 4 N*m}",)
    text = said(capsys, "duty", WEAR_RIG, "--motor", "ESM04X-101-302", "--gearbox", "reference-5-1", "--set", *hot)
    assert "Too hot: the winding exceeds its limit" in text


@pytest.mark.long
def test_a_simulated_recording_is_as_warm_as_its_profile(capsys):
    """Ripple and wander add little to the mean square of the torque."""
    said(capsys, "simulate", WEAR_RIG, "--duration", "3 s", "--truth", "--out", "run.parquet")
    name = "rms torque N*m"
    recorded = said(capsys, "duty", WEAR_RIG, "--recording", "run.parquet")
    asked = said(capsys, "duty", WEAR_RIG)
    assert float(figure_of(recorded, name)[0]) == pytest.approx(float(figure_of(asked, name)[0]), rel=0.05)


def test_a_table_is_simulated_for_its_length_and_its_gap_refused(capsys):
    Path("c.csv").write_text("time_s,output_speed_rpm,torque_Nm\n0,100,1\n0.3,200,2\n0.5,200,2\n")
    said(capsys, "simulate", WEAR_RIG, "--profile", "c.csv", "--out", "run.parquet")
    assert "12500 samples at 25000 Hz, 0.5 s" in said(capsys, "info", "run.parquet")
    Path("c.csv").write_text("time_s,output_speed_rpm,torque_Nm\n0,100,1\n0.3,,2\n0.5,200,2\n")
    for command in ("simulate", "duty"):
        told = said(capsys, command, WEAR_RIG, "--profile", "c.csv", code=2)
        assert "c.csv:3: the profile has a gap: output_speed_rpm is no number; write the value" in told


REFUSED = {
    "torque": (("--set", "load.occupancy=21", "--set", "motor.torque_limit=0.5 N*m"), "its drive's limit is 0.5 N*m"),
    "speed": (("--set", "output_speed=1300 rpm"), "needs 6500 rpm, reaches at most 6000 rpm"),
    "profile": (
        ("--profile", "steadi"),
        "--profile steadi: is neither a profile nor a table file; did you mean 'steady'?",
    ),
    "no table": (("--profile", "no.csv"), "no.csv: there is no such file of a profile"),
}


@pytest.mark.parametrize("command", ["simulate", "duty"])
@pytest.mark.parametrize(("arguments", "told"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_is_refused_before_a_simulation(capsys, command, arguments, told):
    assert told in said(capsys, command, WEAR_RIG, *arguments, code=2)
    assert not list(Path().glob("*.parquet"))


def test_a_profile_that_ends_too_soon_and_a_study_of_a_cycle_are_refused(capsys):
    cycle = "operating_point.duty_cycle={repeats: 2, segments: [{duration: 1 s, motor_speed: 500 rpm}]}"
    chosen = ("--set", cycle, "--set", "operating_point.profile=duty_cycle")
    told = said(capsys, "simulate", WEAR_RIG, *chosen, "--duration", "5 s", code=2)
    assert "operating_point: the profile duty_cycle ends after 2 s, and the run lasts 5 s" in told
    told = said(capsys, "compare", WEAR_RIG, *chosen, code=2)
    assert "a study compares drives at one operating point, and duty_cycle has many; write steady" in told


def test_a_motor_that_no_catalog_has_has_no_known_heat(capsys):
    own = ("--set", "rig.motor={kind: motor, inertia: 1.5e-4 kg*m^2, torque_limit: 2 N*m}")
    assert "the driven motor is not in the catalog" in said(capsys, "duty", WEAR_RIG, *own, code=2)
    assert "--duration: 0 s must be more than 0" in said(capsys, "duty", WEAR_RIG, "--duration", "0 s", code=2)
