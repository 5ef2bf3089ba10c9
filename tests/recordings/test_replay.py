"""A channel over again: same samples, other rates, and what is refused."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import InputError, RecordingError
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.replay import recording_at, replayed_motion, replayed_torque

RATE, TIME = 5000.0, np.arange(5000) / 5000.0
SWING = np.sin(2 * pi * 40 * TIME + 0.2)


def recording(**channels: Channel) -> Recording:
    return Recording(sample_rate=RATE, channels=channels, name="run7.parquet")


MADE = recording(
    torque_V=Channel(values=SWING, quantity="torque", unit="V", si_per_unit=2.0),
    current_A=Channel(values=SWING, quantity="current", unit="A"),
    force_N=Channel(values=SWING, quantity="force", unit="N"),
    motor_rpm=Channel(values=600 + 30 * SWING, quantity="motor_speed", unit="rpm", si_per_unit=2 * pi / 60),
    slide_mm=Channel(values=SWING, quantity="position", unit="mm", si_per_unit=1e-3),
    oven_degC=Channel(values=SWING, quantity="temperature", unit="degC"),
)


def test_at_its_own_rate_the_samples_come_back_bit_for_bit_in_si() -> None:
    time = np.arange(-100, 4001) / RATE
    found = replayed_torque(MADE, "torque_V", factor=-3.0).at(time)
    assert np.array_equal(found[100:], -3.0 * (2.0 * SWING[:4001]))
    assert np.all(found[:100] == found[100])  # held before the recording


def test_by_quantity_and_with_a_torque_constant() -> None:
    time = np.arange(10) / RATE
    assert replayed_torque(MADE, "current", torque_constant=0.11).at(time) == pytest.approx(0.11 * SWING[:10])
    assert replayed_torque(MADE, "force").at(time) == pytest.approx(SWING[:10])


@pytest.mark.parametrize(("rate", "within"), [(25_000.0, 1e-4), (7_300.0, 1e-4), (1_000.0, 1e-3)])
def test_another_rate_gives_the_same_signal(rate: float, within: float) -> None:
    """Thinning filters forwards and backwards: 40 Hz stays, apart from the ends."""
    time = np.arange(int(0.9 * rate)) / rate
    inner = slice(int(0.05 * rate), None)
    found = replayed_torque(MADE, "force_N").at(time)
    assert found[inner] == pytest.approx(np.sin(2 * pi * 40 * time + 0.2)[inner], abs=within)


def test_thinning_out_folds_nothing_back() -> None:
    """2 kHz at 5 kHz would read as 0 Hz at 1 kHz."""
    high = recording(torque_Nm=Channel(values=np.cos(2 * pi * 2000 * TIME), quantity="torque", unit="N*m"))
    found = replayed_torque(high, "torque").at(np.arange(900) / 1000.0)
    assert np.abs(found[50:-50]).max() < 1e-3


def test_a_speed_gives_its_angle_and_an_angle_its_speed() -> None:
    time = np.arange(-500, 20_000) / 25_000.0
    angle, speed = replayed_motion(MADE, "motor_speed").at(time)
    w, f = 2 * pi / 60, 2 * pi * 40
    inner = slice(600, None)
    assert speed[inner] == pytest.approx((w * (600 + 30 * np.sin(f * time + 0.2)))[inner], rel=1e-5)
    expected = w * (600 * time + 30 / f * (np.cos(0.2) - np.cos(f * time + 0.2)))
    assert angle[inner] == pytest.approx(expected[inner], abs=1e-5)
    assert np.diff(angle[:500]) == pytest.approx(speed[0] / 25_000.0)  # turns on evenly before
    place, moving = replayed_motion(MADE, "slide_mm").at(time)
    assert place[inner] == pytest.approx(1e-3 * np.sin(f * time + 0.2)[inner], abs=1e-7)
    assert moving[inner] == pytest.approx(1e-3 * f * np.cos(f * time + 0.2)[inner], abs=1e-4)


def test_counts_that_run_over_are_unwrapped_and_smoothed() -> None:
    turned = 60.0 * TIME
    counts = np.floor(turned / (2 * pi / 4096)) % 4096
    wheel = recording(wheel=Channel(values=counts, quantity="angle", unit="count", si_per_unit=2 * pi / 4096))
    speed = replayed_motion(wheel, "wheel").at(np.arange(4000) / RATE)[1]
    assert speed[100:].mean() == pytest.approx(60.0, rel=1e-3)


GAP = recording(torque_Nm=Channel(values=np.where(abs(TIME - 0.5) < 0.01, np.nan, 1.0), quantity="torque", unit="N*m"))


@pytest.mark.parametrize(
    ("made", "channel", "told"),
    [
        (MADE, "torque_Vv", "run7.parquet has no channel 'torque_Vv'; did you mean 'torque' or 'torque_V'"),
        (MADE, "oven_degC", "oven_degC of run7.parquet is a temperature, not a torque"),
        (MADE, "current_A", "is a current; add torque_constant:"),
        (GAP, "torque_Nm", "has a gap of 99 samples that are not numbers, from 0.4902 s on"),
    ],
)
def test_what_is_no_torque_is_refused(made: Recording, channel: str, told: str) -> None:
    with pytest.raises(RecordingError, match=told):
        replayed_torque(made, channel)


def test_a_force_is_no_motion() -> None:
    with pytest.raises(RecordingError, match=r"force_N of run7.parquet is a force, and a motion needs"):
        replayed_motion(MADE, "force")


def test_a_run_longer_than_the_recording_is_refused() -> None:
    signal = replayed_torque(MADE, "torque_V")
    assert signal.at(np.arange(5001) / RATE).size == 5001  # its own length, and the sample that closes the last
    with pytest.raises(InputError, match=r"torque_V of run7.parquet lasts 1 s, and the run 1.2 s"):
        signal.at(np.arange(6001) / RATE)


def test_a_file_is_read_again_only_when_it_changes(tmp_path: Path) -> None:
    path = tmp_path / "one.csv"
    plain = recording(torque_Nm=Channel(values=SWING, quantity="torque", unit="N*m"))
    write_recording(plain, path)
    assert recording_at(path) is recording_at(path)
    with pytest.raises(InputError, match=r"two.csv: there is no such file"):
        recording_at(tmp_path / "two.csv")
