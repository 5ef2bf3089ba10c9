"""What the commands say of the speed: encoders that wrap or are miscounted, no set-point, no encoder."""

import numpy as np
import pandas as pd
import pytest

from torquerig.cli import main


@pytest.fixture
def run(capsys):
    def of(*arguments):
        code = 0
        try:
            main([str(each) for each in arguments])
        except SystemExit as end:
            code = end.code
        shown = capsys.readouterr()
        return code, " ".join((shown.out + shown.err).split())

    return of


def written(tmp_path, sidecar, *, rpm=1000.0, rate=2000.0, seconds=8, tones=None, lines=None, noise=0.01, **channels):
    """Write a torque with amplitudes of motor orders and of fixed frequencies; channels are functions of the turns."""
    at = np.arange(int(rate * seconds)) / rate
    turns = rpm / 60 * at
    torque = 2 + noise * np.random.default_rng(5).standard_normal(at.size)
    torque += sum(size * np.sin(2 * np.pi * order * turns) for order, size in (lines or {1: 0.05, 6: 0.05}).items())
    torque += sum(size * np.sin(2 * np.pi * hertz * at) for hertz, size in (tones or {}).items())
    columns = {"torque_Nm": torque, **{name: of(turns) for name, of in channels.items()}}
    path = tmp_path / "run.parquet"
    pd.DataFrame(columns).to_parquet(path)
    path.with_suffix(".yaml").write_text(f"sample_rate_Hz: {rate:g}\n{sidecar}")
    return path


TORQUE = "channels:\n  torque_Nm: {quantity: torque, unit: Nm}\n"
ANGLE = TORQUE + "  ang: {quantity: motor_angle, unit: deg}\n"
COUNTS = TORQUE + "  enc: {quantity: motor_angle, unit: count, counts_per_rev: 1024}\n"
RUN = "run: {motor: bldc-12n14p, gear_ratio: 5, speed_rpm: 1000}\n"


@pytest.mark.long
def test_an_encoder_in_degrees_that_wraps_is_unwrapped_and_named(tmp_path, run):
    path = written(tmp_path, ANGLE + RUN, ang=lambda turns: 360 * turns % 360)
    for command in ("info", "ordermap", "filter"):
        code, output = run(command, path)
        assert code == 0, output
        assert "which wraps at 360 deg" in output
        assert "suspicious" not in output
    assert "motor speed: 1000 rpm" in run("info", path)[1]
    assert "cogging per pole x1" in run("ordermap", path)[1]
    filtered = run("filter", path, "--chain", "order_lines")[1].split("order_lines ")[1].split()
    assert float(filtered[1]) > 70  # the standard deviation falls by 1 - 0.01 / 0.051


@pytest.mark.parametrize("command", ["info", "ordermap", "filter"])
def test_wrong_counts_per_turn_are_named(command, tmp_path, run):
    path = written(tmp_path, COUNTS + RUN, enc=lambda turns: np.floor(4096 * turns))
    code, output = run(command, path)
    assert code == 0, output
    assert "suspicious: enc says 4000" in output
    assert "4096 counts per turn?" in output


def test_filter_takes_the_speed_of_the_encoder(tmp_path, run):
    sidecar = ANGLE + "run: {gear_ratio: 1, motor: GP-71M}\n"
    path = written(
        tmp_path, sidecar, rpm=3200.0, rate=1000.0, lines={1: 0.1, 2: 0.03}, ang=lambda turns: 800 + 360 * turns
    )
    assert "motor speed: 3200 rpm (from the channel ang)" in run("info", path)[1]
    code, output = run("filter", path, "--picture", tmp_path / "a.svg", "--chain", "report_filter_code")
    assert code == 0, output
    assert "speed for energy and lines: from the channel ang" in output


def test_a_message_suggests_no_speed_that_is_not_known(tmp_path, run):
    path = written(tmp_path, TORQUE + "run: {gear_ratio: 1, motor: GP-71M}\n")
    code, output = run("filter", path)
    assert code == 2
    assert "run: {speed_rpm: N}" in output


def test_info_invents_no_speed(tmp_path, run):
    path = written(tmp_path, TORQUE + RUN, lines={1: 0.5}, rate=5000.0, seconds=10, noise=0.005)
    assert "motor speed: 1000 rpm +- 1 % (from the set-point alone" in run("info", path)[1]
    sidecar = TORQUE + RUN.replace("1000", "1010")
    path = written(tmp_path, sidecar, rpm=1010.0, rate=5000.0, seconds=20, lines={1: 0.05, 2: 0.03, 4: 0.02},
                   tones={50: 0.04})  # fmt: skip
    speed, _, half_width = run("info", path)[1].split("motor speed: ")[1].split(" %")[0].split(" ", 2)
    assert float(speed) == pytest.approx(1010, rel=float(half_width.removeprefix("+- ")) / 100)
