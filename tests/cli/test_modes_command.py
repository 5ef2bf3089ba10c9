"""``torquerig modes`` as a user meets it: the wear rig's modes, margins and crossings, the picture, bad input."""

from __future__ import annotations

from pathlib import Path

import pytest

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.cli import main

WEAR_RIG = str(shipped_scenarios() / "wear_rig.yaml")


def run(*arguments: str) -> int:
    try:
        main(("modes", *arguments))
    except SystemExit as stopped:
        return int(stopped.code or 0)
    return 0


def test_the_wear_rig_is_told_with_modes_margins_and_crossings(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(WEAR_RIG) == 0
    out = capsys.readouterr().out
    # the reference rig's first mode: handbook, simulators 6 and the series of its stiffnesses
    assert "linear about 1000 rpm of motor" in out
    assert "twist in torque_sensor" in out
    assert "speed_controller: stable; crossover 29.39 Hz" in out
    assert "motor.cogging                         6     1  127.46     1274.6" in out
    assert "omitted: the torque limit of the motor" in out


def test_settings_move_the_modes(capsys: pytest.CaptureFixture[str]) -> None:
    stiffness = "rig.torque_sensor.stiffness=4000 N*m/rad"
    assert run(WEAR_RIG, "--set", stiffness, "--speed-max", "500 rpm", "--crossings", "2") == 0
    out = capsys.readouterr().out
    assert "127.01" not in out
    assert "up to 500 rpm" in out


def test_an_unstable_loop_is_called_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(WEAR_RIG, "--set", "rig.speed_controller.kp=20 N*m*s/rad") == 0
    assert "UNSTABLE" in capsys.readouterr().out


def test_the_picture_is_drawn_once_and_not_overwritten(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "modes.svg"
    assert run(WEAR_RIG, "--picture", str(picture)) == 0
    first = picture.read_bytes()
    assert run(WEAR_RIG, "--picture", str(picture)) == 2
    assert "is there already" in capsys.readouterr().err
    assert run(WEAR_RIG, "--picture", str(picture), "--force") == 0
    assert picture.read_bytes() == first


IMPOSED = """
operating_point: {}
measured: motion
rig:
  table: {kind: slide, mass: 3 kg}
  rod: {kind: link, stiffness: 1.0e6 N/m, damping: 50 N*s/m}
  block: {kind: slide, mass: 4 kg}
  motion: {kind: imposed_motion, at: table, channel: position}
"""


def test_what_an_imposed_motion_moves_is_clamped(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario = tmp_path / "imposed.yaml"
    scenario.write_text(IMPOSED, encoding="utf-8")
    assert run(str(scenario)) == 0
    out = capsys.readouterr().out
    # sqrt(1e6 / 4) / 2 pi = 79.577 Hz: the block on its rod, the table held
    assert "79.577" in out
    assert "motion imposes the motion" in out
    assert run(str(scenario), "--picture", str(tmp_path / "modes.svg")) == 2
    assert "no spring torque is measured" in capsys.readouterr().err
    assert not (tmp_path / "modes.svg").exists()


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--speed-max", "5 N*m"), "--speed-max"),
        (("--speed-max", "0 rpm"), "more than 0"),
        (("--rate", "0 Hz"), "more than 0"),
        (("--picture", "modes.bmp"), "written as .svg or .png"),
    ],
    ids=["unit", "speed", "rate", "ending"],
)
def test_bad_options_are_one_sentence(
    arguments: tuple[str, ...], told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert run(WEAR_RIG, *arguments) == 2
    error = capsys.readouterr().err
    assert told in error
    assert error.count("\n") == 1


def test_simulate_proves_its_step_in_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(("simulate", WEAR_RIG, "--duration", "0.4 s", "--out", str(tmp_path / "run.parquet"), "--prove-step"))
    out = " ".join(capsys.readouterr().out.split())
    assert "fixed by the mode at 1945 Hz (twist in 'coupling')" in out
    assert "within the tolerance of 0.00031 N*m (one step of its converter): proven" in out


def test_a_spring_with_both_ends_held_is_not_called_missing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scenario = tmp_path / "held.yaml"
    both = IMPOSED + "  other: {kind: imposed_motion, at: block, channel: position}\n"
    scenario.write_text(both, encoding="utf-8")
    assert run(str(scenario)) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "no modes: both ends of every torsional spring are held, by an imposed motion or a locked end" in out


def test_a_damped_frequency_above_the_undamped_one_is_explained(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """sqrt(k (1/J1 + 1/J2)) is 159 Hz; with 1/eta of the torque on J1, sqrt(k (1/(eta J1) + 1/J2)) is 184 Hz."""
    scenario = tmp_path / "lossy.yaml"
    scenario.write_text(
        """
operating_point: {motor_speed: 100 rpm}
measured: gear
rig:
  motor: {kind: motor, inertia: 10 kg*cm^2, torque_limit: 500 N*m}
  gear: {kind: gear, ratio: 1, stiffness: 500 N*m/rad, damping: 0.001 N*m*s/rad, efficiency: 0.6}
  end: {kind: body, inertia: 10 kg*cm^2, viscous: 0.01 N*m*s/rad}
  loop: {kind: speed_controller, kp: 0.05 N*m*s/rad, ki: 0.5 N*m/rad}
""",
        encoding="utf-8",
    )
    assert run(str(scenario)) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert "1 159.15 183.7" in out
    assert "damped above undamped: damping or friction holds a shaft that swings in the undamped mode" in out
    assert run(WEAR_RIG, "--set", "gearbox.efficiency=1") == 0
    assert "holds a shaft" not in capsys.readouterr().out
