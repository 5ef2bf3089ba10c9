"""``torquerig ordermap``: the lines it tells, its picture, and what it refuses."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, SECONDS = 5000.0, 10.0
SCENARIO = Path(__file__).resolve().parents[2] / "scenarios" / "wear_rig.yaml"


@pytest.fixture
def ramp(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    time = np.arange(int(RATE * SECONDS)) / RATE
    top = 1000 * pi / 30
    angle = np.cumsum(top * np.where(time < 0.9 * SECONDS, 0.1 + time / SECONDS, 1.0)) / RATE
    torque = 1 + 0.05 * np.cos(7 * angle) + 0.05 * np.cos(2 * pi * 50 * time)
    torque += 0.01 * np.random.default_rng(1).normal(size=time.size)
    channels = {
        "torque_V": Channel(values=torque, quantity="torque", unit="V"),
        "angle_rad": Channel(values=angle, quantity="motor_angle", unit="rad"),
    }
    run = Run(motor="bldc-12n14p", gear_ratio=5.0, speed=top, profile="ramp")
    write_recording(Recording(sample_rate=RATE, channels=channels, run=run), tmp_path / "ramp.parquet")
    return tmp_path


def test_it_tells_shaft_from_grid_and_draws(ramp, capsys):
    main(("ordermap", "ramp.parquet", "--scenario", str(SCENARIO), "--picture", "orders.svg"))
    told = capsys.readouterr().out
    found = told[told.index("constant  ") :]
    shaft = next(row for row in found.splitlines() if row.startswith("order "))
    fixed = next(row for row in found.splitlines() if row.startswith("frequency "))
    assert "electrical x1" in shaft
    assert "1 x mains" in fixed
    drawn = (ramp / "orders.svg").read_bytes()
    main(("ordermap", "ramp.parquet", "--scenario", str(SCENARIO), "--picture", "orders.svg", "--force"))
    assert (ramp / "orders.svg").read_bytes() == drawn


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--mains", "0 Hz"), "write for example '50 Hz'"),
        (("--mains", "50 N"), "--mains"),
        (("--scenario", str(SCENARIO), "--ratio", "5"), "remove --motor, --ratio and --gearbox"),
        (("--picture", "orders.pdf"), "written as .svg or .png"),
        (("--motor", "bldc"), "bldc-12n14p"),
    ],
)
def test_what_cannot_be_used_is_refused(ramp, capsys, arguments, said):
    with pytest.raises(SystemExit) as left:
        main(("ordermap", "ramp.parquet", *arguments))
    assert left.value.code == 2
    assert said in capsys.readouterr().err


def test_without_motor_and_ratio_it_lists_the_lines_and_says_what_is_not_stated(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    times = np.arange(8000) / 1000
    torque = 2 + 0.3 * np.cos(2 * pi * 7 * 20 * times) + 0.01 * np.random.default_rng(1).normal(size=times.size)
    rows = "".join(f"{t:.3f},{v:.6f},1200\n" for t, v in zip(times, torque, strict=True))
    (tmp_path / "run.csv").write_text("Time [s],Torque [Nm],Speed [rpm]\n" + rows)
    for command in ("ordermap", "filter"):
        main((command, "run.csv", *(("--chain", "order_lines") if command == "filter" else ())))
        told = " ".join(capsys.readouterr().out.split())
        assert "the motor is not stated, so the lines of its poles and slots are not known" in told
        assert "no gear ratio is stated, so the output shaft is taken to turn with the motor" in told
        if command == "ordermap":
            assert "7 order 0.3" in told


def test_amplitudes_of_a_force_are_in_newtons(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    time = np.arange(5000) / 1000
    force = 10 * np.sin(2 * pi * 30 * time) + 0.1 * np.random.default_rng(1).normal(size=time.size)
    channels = {"force_N": Channel(values=force, quantity="force", unit="N")}
    write_recording(Recording(sample_rate=1000, channels=channels, run=Run()), tmp_path / "axis.parquet")
    main(("ordermap", "axis.parquet"))
    told = capsys.readouterr().out
    assert "amplitude N " in told
    line = next(row for row in told.splitlines() if row.strip().startswith("30 "))
    assert float(line.split()[1]) == pytest.approx(10, rel=2e-3)


def slow_output(tmp_path, *, motor_turns):
    """A ratio of 100: a line at motor order 6, over few turns of the motor."""
    turns = np.linspace(0, motor_turns, 20_000)
    torque = 1 + 0.2 * np.cos(2 * pi * 6 * turns + 1) + 0.01 * np.random.default_rng(1).normal(size=turns.size)
    channels = {
        "torque_Nm": Channel(values=torque, quantity="torque", unit="N*m"),
        "angle": Channel(values=2 * pi * turns, quantity="motor_angle", unit="rad"),
    }
    run = Run(gear_ratio=100.0, speed=2 * pi * motor_turns / 4)
    write_recording(Recording(sample_rate=5000, channels=channels, run=run), tmp_path / "slow.parquet")


def test_a_slow_output_shaft_counts_the_turns_of_the_motor(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    slow_output(tmp_path, motor_turns=60)
    main(("ordermap", "slow.parquet", "--picture", "orders.svg"))
    told = capsys.readouterr().out
    assert "motor turns 60 times" in " ".join(told.split())
    found = told[told.index("constant  ") :]
    line = next(row for row in found.splitlines() if "order" in row and "0.2" in row)
    assert float(line.split()[1]) == pytest.approx(600, rel=0.01) or "600 order" in line
    assert (tmp_path / "orders.svg").exists()


def test_orders_need_two_turns_of_one_shaft(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    slow_output(tmp_path, motor_turns=1.5)
    with pytest.raises(SystemExit):
        main(("ordermap", "slow.parquet"))
    assert "0.01 times, the fastest shaft 1.5 times" in capsys.readouterr().err


def test_a_motor_torque_is_refused_with_the_option_that_takes_it(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    channels = {"Iq": Channel(values=np.ones(5000), quantity="motor_torque", unit="N*m")}
    write_recording(Recording(sample_rate=1000, channels=channels, run=Run()), tmp_path / "motor.parquet")
    with pytest.raises(SystemExit):
        main(("ordermap", "motor.parquet"))
    assert "--channel Iq" in capsys.readouterr().err
