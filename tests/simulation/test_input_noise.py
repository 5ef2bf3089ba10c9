"""Coarse positions as inputs: the noise of their speed as stated, and the warning that names it."""

from math import pi, sqrt

import numpy as np
import pytest

from torquerig.cli import main
from torquerig.recordings.channel_angle import angle_of
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.simulation.input_noise import noisy_speed, resolution_of

RATE = 1000.0
TIME = np.arange(8000) / RATE
SWING = 0.1 * np.sin(2 * pi * 0.7 * TIME)  # [m]
SLIDE = """
operating_point: {}
measured: motion
rig:
  carriage: {kind: slide, mass: 10 kg}
  motion: {kind: imposed_motion, at: carriage, from: channel x}
"""


def position(step):
    values = SWING if step == 0 else np.round(SWING / step) * step
    return Channel(values=values, quantity="position", unit="m")


def counts(per_turn, *, turns=0.37):
    return Channel(values=np.floor(turns * TIME * per_turn), quantity="motor_angle", unit="count",
                   si_per_unit=2 * pi / per_turn)  # fmt: skip


@pytest.mark.parametrize("step", [1e-3, 1e-5])
def test_the_step_of_a_position_is_seen(step):
    assert resolution_of(position(step)) == pytest.approx(step, rel=1e-6)


@pytest.mark.parametrize("values", [SWING, 0.3 * TIME, np.zeros(TIME.size)])
def test_a_smooth_or_even_or_resting_position_has_no_step(values):
    assert resolution_of(Channel(values=values, quantity="position", unit="m")) is None


def test_the_stated_noise_is_that_of_the_difference_of_two_samples():
    step = 1e-4
    said = noisy_speed(position(step), RATE, name="x")
    assert said is not None
    stated = float(said.split("a noise of ")[1].split()[0])
    measured = np.std(np.diff(position(step).values - SWING) * RATE)
    assert stated == pytest.approx(step * RATE / sqrt(6), rel=5e-3)
    assert stated == pytest.approx(measured, rel=0.05)


def test_counts_are_smoothed_before_their_speed_is_taken():
    coarse = counts(4096, turns=3.7)
    said = noisy_speed(coarse, RATE, name="encoder")
    assert said is None  # 15 counts a sample, of five samples each
    slow = counts(4096)
    said = noisy_speed(slow, RATE, name="encoder")
    assert said is not None
    stated = float(said.split("a noise of ")[1].split()[0])
    measured = np.std(np.diff(angle_of(slow, RATE))[10:-10] * RATE)
    assert 0.3 * measured < stated < 3 * measured


@pytest.mark.parametrize(
    "channel",
    [position(0), position(1e-8), Channel(values=np.round(SWING, 2), quantity="velocity", unit="m/s")],
)
def test_fine_positions_and_measured_speeds_are_not_warned_of(channel):
    assert noisy_speed(channel, RATE, name="x") is None


def test_a_recording_of_finer_steps_has_less_noise():
    shares = [noisy_speed(position(step), RATE, name="x") for step in (1e-3, 1e-4)]
    assert all(shares)
    first, second = (float(one.split(" % of ")[0].split()[-1]) for one in shares if one)
    assert first == pytest.approx(10 * second, rel=0.05)


def test_simulate_warns(tmp_path, capsys):
    (tmp_path / "slide.yaml").write_text(SLIDE)
    for step, warned in ((1e-4, True), (1e-8, False)):
        write_recording(
            Recording(sample_rate=RATE, channels={"x": position(step)}), tmp_path / "run.parquet", overwrite=True
        )
        main(("simulate", str(tmp_path / "slide.yaml"), "--inputs", str(tmp_path / "run.parquet"), "--out",
              str(tmp_path / "out.parquet"), "--force"))  # fmt: skip
        told = " ".join(capsys.readouterr().out.split())
        assert ("warning: x is recorded in steps of 0.0001 m" in told) == warned
